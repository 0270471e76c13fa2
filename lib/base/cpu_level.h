// The level of the x86-64 instruction set that this machine has, for code that is compiled for
// several (cmake/ObbyLanes.cmake).
#pragma once

namespace obby {

// As the x86-64 psABI defines them: v1 has SSE2, v2 SSE4.2, v3 AVX2, v4 AVX-512.
enum class CpuLevel { v1, v2, v3, v4 };

// The highest level of this CPU, but at most the one that the environment's OBBY_CPU_LEVEL names
// ("v1" to "v4"), which tests and benches use. Never changes while the process runs.
CpuLevel cpuLevel();

}  // namespace obby
