#include "nn/device/kernels.h"

#include <type_traits>

#include "nn/cuda/cuda.h"
#include "nn/device/learn_kernels.h"

namespace obby::nn {

namespace {

// Compiles the products for FMA. Without it each fused operation is a call of libm, ten times as
// slow. The bits are the same.
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
sim::Kernel kernelOf(const char* name, Step step) {
  sim::Kernel kernel = sim::makeKernel<Arguments, kFunction>(name, cuda::entry(step));
#if defined(__x86_64__) && !defined(__FMA__)
  if constexpr (kFuses<Arguments>) {
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      kernel.body = fusedBody<Arguments, kFunction>;
  }
#endif
  return kernel;
}

}  // namespace

const sim::Kernel& kernel(Step step) {
#define OBBY_KERNEL(name, arguments, function) \
  kernelOf<arguments, function>("nn." #name, Step::name),
  static const sim::Kernel kernels[] = {OBBY_NN_KERNELS(OBBY_KERNEL)};
#undef OBBY_KERNEL
  return kernels[size_t(step)];
}

}  // namespace obby::nn
