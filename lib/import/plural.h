// Writes counts of things in texts.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace obby::importer {

// Returns "1 part", "3 parts".
inline std::string plural(size_t n, const char* noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

}  // namespace obby::importer
