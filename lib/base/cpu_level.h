// The x86-64 instruction set level of this machine. It selects among code that is compiled for
// several levels (cmake/ObbyLanes.cmake).
#pragma once

namespace obby {

// The levels of the x86-64 psABI: v1 has SSE2, v2 SSE4.2, v3 AVX2, v4 AVX-512.
enum class CpuLevel { v1, v2, v3, v4 };

// Returns the highest level of this CPU, capped by the environment variable OBBY_CPU_LEVEL ("v1" to
// "v4"), which tests and benches set. The result never changes while the process runs.
CpuLevel cpuLevel();

}  // namespace obby
