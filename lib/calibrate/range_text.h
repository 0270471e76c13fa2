// How a report writes a range.
#pragma once

#include <fmt/format.h>

#include <string>

namespace obby::calibrate {

// The ends as they print; one number if both print alike.
inline std::string rangeText(const std::string& low, const std::string& high) {
  return low == high ? low : fmt::format("{} to {}", low, high);
}

}  // namespace obby::calibrate
