#include "train/device/kernels.h"

#include <type_traits>

#include "train/cuda/cuda.h"
#include "train/device/learn_kernels.h"
#include "train/device/play_kernels.h"

namespace obby::train {

namespace {

// Products multiply and add in one step. Where the build's processor cannot, each would be a call
// of libm, ten times as slow; the one at hand mostly can. The bits are the same.
#if defined(__x86_64__) && !defined(__FMA__)
template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
__attribute__((target("avx2,fma"), flatten)) void fusedBody(const void* arguments, uint32_t i) {
  kFunction(*static_cast<const Arguments*>(arguments), i);
}
template <class Arguments>
constexpr bool kFuses =
    std::is_same_v<Arguments, ProductArguments> || std::is_same_v<Arguments, GradientArguments>;
#endif

template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
auto bodyOf() {
#if defined(__x86_64__) && !defined(__FMA__)
  if constexpr (kFuses<Arguments>) {
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      return fusedBody<Arguments, kFunction>;
  }
#endif
  return sim::kernelBody<Arguments, kFunction>;
}

template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
sim::Kernel kernel(const char* name, TrainStep step) {
  static_assert(sizeof(Arguments) <= 4096, "a kernel's arguments on a GPU");
  return {name, bodyOf<Arguments, kFunction>(), cuda::trainEntry(step), sizeof(Arguments)};
}

}  // namespace

const sim::Kernel& trainKernel(TrainStep step) {
#define OBBY_KERNEL(name, arguments, function) \
  kernel<arguments, function>("train." #name, TrainStep::name),
  static const sim::Kernel kernels[] = {OBBY_TRAIN_KERNELS(OBBY_KERNEL)};
#undef OBBY_KERNEL
  return kernels[size_t(step)];
}

}  // namespace obby::train
