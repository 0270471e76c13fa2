// Names of enumeration values in the schema.
#pragma once

#include <capnp/schema.h>

#include <cstdint>
#include <string_view>

namespace obby::view {

// Returns the name as in JSON, or `otherwise` for a value unknown to this schema. Always valid.
template <class Enum>
std::string_view enumName(Enum value, std::string_view otherwise = "running") {
  const auto names = capnp::Schema::from<Enum>().getEnumerants();
  const auto index = uint16_t(value);
  return index < names.size() ? std::string_view(names[index].getProto().getName().cStr())
                              : otherwise;
}

}  // namespace obby::view
