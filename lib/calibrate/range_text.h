// Formats a range for reports.
#pragma once

#include <fmt/format.h>

#include <string>

namespace obby::calibrate {

// Joins the printed ends, or returns one if both print the same.
inline std::string rangeText(const std::string& low, const std::string& high) {
  return low == high ? low : fmt::format("{} to {}", low, high);
}

}  // namespace obby::calibrate
