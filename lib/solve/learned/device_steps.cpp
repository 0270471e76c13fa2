#include "solve/learned/device_steps.h"

#include "solve/learned/device_kernels.h"
#include "solve/search/cuda/cuda.h"

namespace obby::solve::learned {

namespace {

template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
sim::Kernel kernel(const char* name, LearnedStep step) {
  static_assert(sizeof(Arguments) <= 4096, "a kernel's arguments on a GPU");
  return {name, sim::kernelBody<Arguments, kFunction>, cuda::learnedEntry(step), sizeof(Arguments)};
}

}  // namespace

const sim::Kernel& learnedKernel(LearnedStep step) {
  static const sim::Kernel kernels[] = {
      // in the order of LearnedStep
      kernel<SightArguments, seePart>("learnedSee", LearnedStep::see),
      kernel<LayerArguments, layerUnit>("learnedLayer", LearnedStep::layer),
      kernel<GradientArguments, gradientOfWeight>("learnedGradient", LearnedStep::gradient),
      kernel<BackArguments, slopeBefore>("learnedBack", LearnedStep::back)};
  return kernels[size_t(step)];
}

}  // namespace obby::solve::learned
