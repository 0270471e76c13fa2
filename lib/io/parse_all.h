// Parses a number that must be the whole text.
#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace obby::io {

// Returns false, and may have changed `out`, if the text is not one number of the type T.
template <class T>
bool parseAll(std::string_view text, T& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace obby::io
