// The target of a request, split into its parts. Nothing is decoded, because the servers accept
// nothing that needs escapes.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace obby::loopback {

struct Parameter {
  std::string_view name, value;  // empty if there is none
  std::string_view text;         // "name=value" as received
};

struct Target {
  std::string_view path;
  std::vector<Parameter> parameters;  // in order, unchecked
};

// Splits "/path?name=value&...". The caller owns the texts.
Target targetOf(std::string_view text);

// Parses a number of only decimal digits, up to `max`. Returns nothing for any other text.
std::optional<uint64_t> wholeNumber(std::string_view text, uint64_t max);

}  // namespace obby::loopback
