// The kernels of methods that learn while they search, by name.
#pragma once

#include "sim/kernel.h"

namespace obby::solve::learned {

enum class LearnedStep {
  see,       // of SightArguments
  layer,     // of LayerArguments
  gradient,  // of GradientArguments
  back       // of BackArguments
};

const sim::Kernel& learnedKernel(LearnedStep step);

}  // namespace obby::solve::learned
