#include "base/cpu_level.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace obby {
namespace {

CpuLevel levelOfCpu() {
  if (__builtin_cpu_supports("x86-64-v4")) return CpuLevel::v4;
  if (__builtin_cpu_supports("x86-64-v3")) return CpuLevel::v3;
  if (__builtin_cpu_supports("x86-64-v2")) return CpuLevel::v2;
  return CpuLevel::v1;
}

CpuLevel highestAllowed() {
  const char* const text = std::getenv("OBBY_CPU_LEVEL");
  const std::string_view name = text != nullptr ? text : "";
  if (name == "v1") return CpuLevel::v1;
  if (name == "v2") return CpuLevel::v2;
  if (name == "v3") return CpuLevel::v3;
  return CpuLevel::v4;
}

}  // namespace

CpuLevel cpuLevel() {
  static const CpuLevel level = std::min(levelOfCpu(), highestAllowed());
  return level;
}

}  // namespace obby
