// What kind of machine this is: times compare only between machines of a kind.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "simd/wide.h"

namespace obby::bench {

// As "AMD EPYC, 8 lanes": the CPU's name, and how many floats a SIMD register of this build holds.
// Virtual machines often hide all but the family, and the lanes then tell generations apart.
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
