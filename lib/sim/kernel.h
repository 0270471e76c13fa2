// A kernel is a function of an argument struct and an index, with two ways to run it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace obby::sim {

// The kernels that step worlds. There are three, because code that never runs still costs a GPU
// registers and stack.
enum class StepKind {
  oneLevel,    // without dynamic bodies
  manyLevels,  // without dynamic bodies
  bodies       // levels with or without dynamic bodies
};

struct Kernel {
  const char* name;
  // Runs one index on the CPU.
  void (*body)(const void* arguments, uint32_t index);
  // A __global__ void(Arguments, uint32_t count) for cudaLaunchKernel; null without CUDA.
  const void* entry;
  size_t argumentBytes;
};

// The Kernel::body of a function with typed arguments.
template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
void kernelBody(const void* arguments, uint32_t index) {
  kFunction(*static_cast<const Arguments*>(arguments), index);
}

// Returns the kernel of a function. `entry` is Kernel::entry.
template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
Kernel makeKernel(const char* name, const void* entry) {
  static_assert(sizeof(Arguments) <= 4096, "a kernel's arguments on a GPU");
  return {name, kernelBody<Arguments, kFunction>, entry, sizeof(Arguments)};
}

}  // namespace obby::sim
