#include "io/json_encode.h"

#include <fmt/format.h>

#include "io/checks.h"

namespace obby::io {

bool JsonEncoder::record(capnp::DynamicStruct::Reader record) {
  KJ_IF_MAYBE (kind, record.which()) {
    const FieldPlan& plan = recordPlan().fields[kind->getIndex()];
    out.open('{').field("type", plan.name);
    if (!fields(*plan.type.record, record.get(*kind).as<capnp::DynamicStruct>(), Path{}))
      return false;
    out.close();
    return true;
  }
  error = makeError("cannot write this record as JSON: this program does not know its type");
  return false;
}

bool JsonEncoder::fields(const StructPlan& plan, capnp::DynamicStruct::Reader in,
                         const Path& path) {
  for (const FieldPlan& field : plan.fields) {
    if (!field.always && !isSet(field, in)) continue;
    out.key(field.name);
    const Path here{&path, field.name};
    if (!value(field.type, in.get(field.field), here)) return false;
  }
  return true;
}

bool JsonEncoder::object(const StructPlan& plan, capnp::DynamicStruct::Reader in,
                         const Path& path) {
  if (plan.tuple) return tuple(plan, in, path);
  out.open('{');
  if (!fields(plan, in, path)) return false;
  out.close();
  return true;
}

bool JsonEncoder::tuple(const StructPlan& plan, capnp::DynamicStruct::Reader in, const Path& path) {
  out.open('[');
  for (size_t i = 0; i < plan.fields.size(); i++) {
    const Path here{&path, {}, int64_t(i)};
    if (!value(plan.fields[i].type, in.get(plan.fields[i].field), here)) return false;
  }
  out.close();
  return true;
}

bool JsonEncoder::list(const TypePlan& element, capnp::DynamicList::Reader in, const Path& path) {
  out.open('[');
  for (uint32_t i = 0; i < in.size(); i++) {
    const Path here{&path, {}, int64_t(i)};
    if (!value(element, in[i], here)) return false;
  }
  out.close();
  return true;
}

bool JsonEncoder::value(const TypePlan& type, const capnp::DynamicValue::Reader& in,
                        const Path& path) {
  if (auto wrong = refuseScalar(type, in)) return fail(path, *wrong);
  switch (type.kind) {
    case ValueKind::boolean: out.value(in.as<bool>()); return true;
    case ValueKind::whole:
      type.isSigned ? out.value(in.as<int64_t>()) : out.value(in.as<uint64_t>());
      return true;
    case ValueKind::whole64:
      out.value(type.isSigned ? fmt::to_string(in.as<int64_t>())
                              : fmt::to_string(in.as<uint64_t>()));
      return true;
    case ValueKind::real32: out.value(in.as<float>()); return true;
    case ValueKind::real64: out.value(in.as<double>()); return true;
    case ValueKind::text: {
      const auto text = in.as<capnp::Text>();
      out.value(std::string_view(text.begin(), text.size()));
      return true;
    }
    case ValueKind::name: {
      KJ_IF_MAYBE (name, in.as<capnp::DynamicEnum>().getEnumerant()) {
        out.value(name->getProto().getName().cStr());
      }
      return true;
    }
    case ValueKind::record: return object(*type.record, in.as<capnp::DynamicStruct>(), path);
    case ValueKind::list: return list(type.element[0], in.as<capnp::DynamicList>(), path);
  }
  return true;
}

bool JsonEncoder::fail(const Path& path, std::string message) {
  error = Error{{}, {}, path.text(), std::move(message), {}};
  return false;
}

}  // namespace obby::io
