#include "loopback/target.h"

#include <algorithm>
#include <charconv>

namespace obby::loopback {

Target targetOf(std::string_view text) {
  Target out;
  out.path = text.substr(0, text.find('?'));
  text.remove_prefix(std::min(text.size(), out.path.size() + 1));
  while (!text.empty()) {
    const std::string_view pair = text.substr(0, text.find('&'));
    text.remove_prefix(std::min(text.size(), pair.size() + 1));
    const std::string_view name = pair.substr(0, pair.find('='));
    out.parameters.push_back({name, pair.substr(std::min(pair.size(), name.size() + 1)), pair});
  }
  return out;
}

std::optional<uint64_t> wholeNumber(std::string_view text, uint64_t max) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return {};
  return value <= max ? std::optional(value) : std::nullopt;
}

}  // namespace obby::loopback
