#include "io/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "io/text.h"

namespace obby::io {

std::string expectation(const TypePlan& type) {
  switch (type.kind) {
    case ValueKind::boolean: return "true or false";
    case ValueKind::whole: return fmt::format("a whole number from {} to {}", type.min, type.max);
    case ValueKind::whole64:
      return type.isSigned
                 ? fmt::format("a whole number from {} to {} in quotes", INT64_MIN, INT64_MAX)
                 : fmt::format("a whole number from 0 to {} in quotes", UINT64_MAX);
    case ValueKind::real32:
    case ValueKind::real64:
      if (type.ranged) return fmt::format("a number from {} to {}", type.min, type.max);
      return "a number";
    case ValueKind::text: return "text";
    case ValueKind::name: return fmt::format("one of {}", fmt::join(enumerants(type.names), ", "));
    case ValueKind::record:
      if (type.record->tuple) return fmt::format("{} numbers", type.record->fields.size());
      return "an object";
    case ValueKind::list: return "an array";
  }
  return {};
}

std::optional<std::string> refuseReal(const TypePlan& type, double value) {
  if (!std::isfinite(value)) return fmt::format("expected a finite number, found {}", value);
  // The bounds are rounded as the field is: the float nearest to 0.2 is a little larger.
  const bool narrow = type.kind == ValueKind::real32;
  const double min = narrow ? double(float(type.min)) : type.min;
  const double max = narrow ? double(float(type.max)) : type.max;
  if (value < std::min(type.min, min) || value > std::max(type.max, max))
    return fmt::format("expected a number from {} to {}, found {}", type.min, type.max, value);
  return std::nullopt;
}

std::optional<std::string> refuseWhole(const TypePlan& type, double value) {
  if (value >= type.min && value <= type.max && std::trunc(value) == value) return std::nullopt;
  return fmt::format("expected {}, found {}", expectation(type), value);
}

std::vector<std::string> enumerants(const capnp::EnumSchema& names) {
  std::vector<std::string> out;
  for (auto name : names.getEnumerants()) out.emplace_back(name.getProto().getName().cStr());
  return out;
}

bool isSet(const FieldPlan& field, capnp::DynamicStruct::Reader in) {
  if (!in.has(field.field, capnp::HasMode::NON_DEFAULT)) return false;
  switch (field.type.kind) {
    case ValueKind::text: return in.get(field.field).as<capnp::Text>().size() > 0;
    case ValueKind::list: return in.get(field.field).as<capnp::DynamicList>().size() > 0;
    case ValueKind::record:
      return !field.type.record->tuple ||
             !tupleEquals(*field.type.record, in.get(field.field).as<capnp::DynamicStruct>(),
                          field.tupleDefault);
    default: return true;
  }
}

std::optional<std::string> refuseScalar(const TypePlan& type,
                                        const capnp::DynamicValue::Reader& value) {
  switch (type.kind) {
    case ValueKind::real32:
    case ValueKind::real64: return refuseReal(type, value.as<double>());
    case ValueKind::whole:
      return type.ranged ? refuseWhole(type, value.as<double>()) : std::nullopt;
    case ValueKind::text: {
      const auto text = value.as<capnp::Text>();
      if (isUtf8(std::string_view(text.begin(), text.size()))) return std::nullopt;
      return "expected UTF-8 text";
    }
    case ValueKind::name: {
      const auto name = value.as<capnp::DynamicEnum>();
      if (name.getEnumerant() != nullptr) return std::nullopt;
      return fmt::format("expected {}, found number {}", expectation(type), name.getRaw());
    }
    default: return std::nullopt;
  }
}

}  // namespace obby::io
