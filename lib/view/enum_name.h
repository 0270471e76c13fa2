// The names that the schema gives to the values of its enumerations.
#pragma once

#include <capnp/schema.h>

#include <cstdint>
#include <string_view>

namespace obby::view {

// As in JSON; `otherwise` for a value that this version's schema does not have. Valid for good.
template <class Enum>
std::string_view enumName(Enum value, std::string_view otherwise = "running") {
  const auto names = capnp::Schema::from<Enum>().getEnumerants();
  const auto index = uint16_t(value);
  return index < names.size() ? std::string_view(names[index].getProto().getName().cStr())
                              : otherwise;
}

}  // namespace obby::view
