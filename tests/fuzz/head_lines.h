// Reads the head of a request from a fuzzer's bytes: method, address, then `Name: value` lines.
#pragma once

#include <algorithm>
#include <string_view>

#include "loopback/sender.h"

namespace obby::fuzz {

inline std::string_view takeLine(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  return line;
}

// `other(name, value)` receives the headers that not all servers read.
template <class Other>
void readHead(std::string_view text, loopback::Head& head, const Other& other) {
  head.method = takeLine(text);
  head.target = takeLine(text);
  while (!text.empty()) {
    const std::string_view line = takeLine(text);
    const size_t colon = line.find(": ");
    if (colon == std::string_view::npos) continue;
    const std::string_view name = line.substr(0, colon), value = line.substr(colon + 2);
    if (name == "Host") head.host = value;
    if (name == "Origin") head.origin = value;
    if (name == "Sec-Fetch-Site") head.fetchSite = value;
    other(name, value);
  }
}

}  // namespace obby::fuzz
