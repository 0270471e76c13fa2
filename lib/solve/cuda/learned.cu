// CUDA entry points of the kernels of methods that learn while they search.
#include "sim/cuda/launch.h"
#include "solve/cuda/cuda.h"
#include "solve/learned/device_kernels.h"

namespace obby::solve::cuda {
using sim::cuda::entry;

const void* learnedEntry(learned::LearnedStep step) {
  using namespace learned;
  switch (step) {
    case LearnedStep::see: return entry<SightArguments, seePart>();
    case LearnedStep::layer: return entry<LayerArguments, layerUnit>();
    case LearnedStep::gradient: return entry<GradientArguments, gradientOfWeight>();
    case LearnedStep::back: break;
  }
  return entry<BackArguments, slopeBefore>();
}

}  // namespace obby::solve::cuda
