// The kind of this machine. Times are comparable only between machines of one kind.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "simd/wide.h"

namespace obby::bench {

// Returns the CPU's name and the floats in a SIMD register of this build, such as "AMD EPYC, 8
// lanes". Virtual machines often hide all but the family; then the lanes distinguish generations.
inline std::string machineKind() {
  std::ifstream cpus("/proc/cpuinfo");
  std::string line, name = "unknown CPU";
  while (std::getline(cpus, line)) {
    if (!line.starts_with("model name")) continue;
    const size_t at = line.find_first_not_of(" \t", line.find(':') + 1);
    if (at != std::string::npos) name = line.substr(at);
    break;
  }
  return fmt::format("{}, {} lanes", name, kLanes);
}

}  // namespace obby::bench
