#include "io/values.h"

#include <fmt/format.h>

#include "io/checks.h"
#include "io/text.h"

namespace obby::io {

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
