#include "io/schema_plan.h"

#include <capnp/message.h>

#include <bit>
#include <limits>
#include <map>
#include <memory>
#include <mutex>

#include "schema/obby.capnp.h"

namespace obby::io {
namespace {

constexpr uint64_t kTupleAnnotation = 0xc1d7c7c3a3a1f0b1;
constexpr uint64_t kRangeAnnotation = 0xd2a9f8e3b7c61a55;
constexpr uint64_t kAlwaysAnnotation = 0x9f4b2c6d81e3a705;
constexpr uint64_t kExampleAnnotation = 0xb3d58e17c20f6a94;
constexpr uint64_t kHintAnnotation = 0xde2f70a9164bc835;
constexpr uint64_t kFormerlyAnnotation = 0xf3a61d0c97b2e854;

// Returns the text of the annotation $formerly, or an empty text if it is absent.
template <class Proto>
std::string formerNameOf(const Proto& proto) {
  for (auto annotation : proto.getAnnotations())
    if (annotation.getId() == kFormerlyAnnotation) return annotation.getValue().getText();
  return {};
}

class Planner {
 public:
  const StructPlan* plan(capnp::StructSchema schema) {
    const uint64_t id = schema.getProto().getId();
    if (auto found = plans_.find(id); found != plans_.end()) return found->second.get();
    StructPlan* made = (plans_[id] = std::make_unique<StructPlan>()).get();
    fill(*made, schema);
    return made;
  }

 private:
  void fill(StructPlan& plan, capnp::StructSchema schema) {
    const auto proto = schema.getProto();
    plan.schema = schema;
    plan.dataWords = proto.getStruct().getDataWordCount();
    plan.pointers = proto.getStruct().getPointerCount();
    for (auto annotation : proto.getAnnotations()) {
      plan.tuple = plan.tuple || annotation.getId() == kTupleAnnotation;
      if (annotation.getId() == kHintAnnotation) plan.hint = annotation.getValue().getText().cStr();
    }
    capnp::MallocMessageBuilder empty;
    const auto defaults = empty.initRoot<capnp::DynamicStruct>(schema).asReader();
    for (auto field : schema.getFields()) plan.fields.push_back(fieldPlan(field, defaults));
    for (size_t i = 0; i < plan.fields.size(); i++) plan.byName[plan.fields[i].name] = i;
    for (size_t i = 0; i < plan.fields.size(); i++) {
      const std::string& former = plan.fields[i].formerly;
      KJ_ASSERT(former.empty() || plan.byName.emplace(former, i).second, former.c_str());
    }
  }

  FieldPlan fieldPlan(capnp::StructSchema::Field field, capnp::DynamicStruct::Reader defaults) {
    FieldPlan out;
    out.name = field.getProto().getName().cStr();
    out.formerly = formerNameOf(field.getProto());
    out.field = field;
    out.type = typePlan(field.getType());
    for (auto annotation : field.getProto().getAnnotations()) {
      out.always = out.always || annotation.getId() == kAlwaysAnnotation;
      if (annotation.getId() == kExampleAnnotation)
        out.example = annotation.getValue().getText().cStr();
      if (annotation.getId() != kRangeAnnotation) continue;
      const auto range = annotation.getValue().getStruct().getAs<schema::Interval>();
      out.type.min = range.getMin();
      out.type.max = range.getMax();
      out.type.ranged = true;
    }
    if (out.type.kind == ValueKind::record && out.type.record->tuple) {
      const auto value = defaults.get(field).as<capnp::DynamicStruct>();
      for (const FieldPlan& part : out.type.record->fields)
        out.tupleDefault.push_back(numberBits(part.type, value.get(part.field)));
    }
    return out;
  }

  TypePlan typePlan(capnp::Type type) {
    TypePlan out;
    out.type = type;
    switch (type.which()) {
      case capnp::schema::Type::BOOL: return sized(out, ValueKind::boolean, 1);
      case capnp::schema::Type::INT8: return whole<int8_t>(out);
      case capnp::schema::Type::INT16: return whole<int16_t>(out);
      case capnp::schema::Type::INT32: return whole<int32_t>(out);
      case capnp::schema::Type::INT64: return whole<int64_t>(out);
      case capnp::schema::Type::UINT8: return whole<uint8_t>(out);
      case capnp::schema::Type::UINT16: return whole<uint16_t>(out);
      case capnp::schema::Type::UINT32: return whole<uint32_t>(out);
      case capnp::schema::Type::UINT64: return whole<uint64_t>(out);
      case capnp::schema::Type::FLOAT32: return real<float>(out, ValueKind::real32);
      case capnp::schema::Type::FLOAT64: return real<double>(out, ValueKind::real64);
      case capnp::schema::Type::TEXT: return sized(out, ValueKind::text, 64);
      case capnp::schema::Type::ENUM:
        out.names = type.asEnum();
        for (auto name : out.names.getEnumerants()) {
          if (std::string former = formerNameOf(name.getProto()); !former.empty())
            out.formerNames.emplace_back(std::move(former), name.getOrdinal());
        }
        return sized(out, ValueKind::name, 16);
      case capnp::schema::Type::STRUCT:
        out.record = plan(type.asStruct());
        return sized(out, ValueKind::record, 0);
      case capnp::schema::Type::LIST:
        out.element.push_back(typePlan(type.asList().getElementType()));
        return sized(out, ValueKind::list, 64);
      default: break;
    }
    KJ_FAIL_ASSERT("the schema uses a type that the codecs do not know");
  }

  static TypePlan sized(TypePlan& out, ValueKind kind, uint32_t bits) {
    out.kind = kind;
    out.elementBits = bits;
    return std::move(out);
  }

  template <class T>
  static TypePlan whole(TypePlan& out) {
    out.isSigned = std::numeric_limits<T>::is_signed;
    out.min = double(std::numeric_limits<T>::min());
    out.max = double(std::numeric_limits<T>::max());
    return sized(out, sizeof(T) == 8 ? ValueKind::whole64 : ValueKind::whole, 8 * sizeof(T));
  }

  template <class T>
  static TypePlan real(TypePlan& out, ValueKind kind) {
    out.min = double(std::numeric_limits<T>::lowest());
    out.max = double(std::numeric_limits<T>::max());
    return sized(out, kind, 8 * sizeof(T));
  }

  std::map<uint64_t, std::unique_ptr<StructPlan>> plans_;
};

}  // namespace

const FieldPlan* StructPlan::find(std::string_view name) const {
  const auto found = byName.find(name);
  return found == byName.end() ? nullptr : &fields[found->second];
}

std::vector<std::string> StructPlan::names() const {
  std::vector<std::string> out;
  for (const FieldPlan& field : fields) out.push_back(field.name);
  return out;
}

const StructPlan& recordPlan() {
  static const StructPlan& plan = planOf(capnp::Schema::from<schema::Record>());
  return plan;
}

const StructPlan& planOf(capnp::StructSchema schema) {
  static std::mutex lock;
  static Planner planner;
  const std::lock_guard hold(lock);
  return *planner.plan(schema);
}

uint64_t numberBits(const TypePlan& type, const capnp::DynamicValue::Reader& value) {
  if (type.kind == ValueKind::real32) return std::bit_cast<uint32_t>(value.as<float>());
  if (type.kind == ValueKind::real64) return std::bit_cast<uint64_t>(value.as<double>());
  return type.isSigned ? uint64_t(value.as<int64_t>()) : value.as<uint64_t>();
}

bool tupleEquals(const StructPlan& plan, capnp::DynamicStruct::Reader value,
                 const std::vector<uint64_t>& bits) {
  for (size_t i = 0; i < plan.fields.size(); i++)
    if (numberBits(plan.fields[i].type, value.get(plan.fields[i].field)) != bits[i]) return false;
  return true;
}

}  // namespace obby::io
