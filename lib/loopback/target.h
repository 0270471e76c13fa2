// The target of a request in its pieces. Nothing is decoded: what our servers take needs no
// escapes.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace obby::loopback {

struct Parameter {
  std::string_view name, value;  // empty where there is none
  std::string_view text;         // "name=value" as it came
};

struct Target {
  std::string_view path;
  std::vector<Parameter> parameters;  // in order, whatever they are
};

// Of "/path?name=value&...". Texts belong to the caller.
Target targetOf(std::string_view text);

// Decimal digits and nothing else, up to `most`.
std::optional<uint64_t> wholeNumber(std::string_view text, uint64_t most);

}  // namespace obby::loopback
