// The codec's place in a record. It is a chain on the stack, and becomes text only for an error.
// Private to lib/io.
#pragma once

#include <string>
#include <string_view>

namespace obby::io {

struct Path {
  const Path* up = nullptr;
  std::string_view name = {};  // a field, or
  int64_t index = -1;          // a list element

  // Returns "parts[88].size".
  std::string text() const {
    std::string out = up ? up->text() : std::string();
    if (index >= 0) return out + "[" + std::to_string(index) + "]";
    if (!out.empty() && !name.empty()) out += '.';
    return out += name;
  }
};

}  // namespace obby::io
