// The learning kernels on a device, by name. OBBY_NN_KERNELS is their only list.
#pragma once

#include "sim/kernel.h"

// X(name, arguments, function)
#define OBBY_NN_KERNELS(X)                                 \
  X(product, ProductArguments, productTile<Fused>)         \
  X(productAsCpu, ProductArguments, productTile<AsCpu>)    \
  X(gradient, GradientArguments, gradientTile<Fused>)      \
  X(gradientAsCpu, GradientArguments, gradientTile<AsCpu>) \
  X(transpose, TransposeArguments, transposeOne)           \
  X(sumColumns, ColumnSumArguments, sumColumnChunk)        \
  X(sumRows, RowSumArguments, sumRows)                     \
  X(chunkMoments, MomentArguments, momentsOfChunk)         \
  X(partMoments, MomentArguments, momentsOfMinibatch)      \
  X(advantages, AdvantageArguments, advantagesOfAgent)     \
  X(squares, StepArguments, squareChunk)                   \
  X(scale, StepArguments, scaleGradient)                   \
  X(update, StepArguments, updateParameter)

namespace obby::nn {

enum class Step {
#define OBBY_NN_STEP(name, arguments, function) name,
  OBBY_NN_KERNELS(OBBY_NN_STEP)
#undef OBBY_NN_STEP
};

const sim::Kernel& kernel(Step step);

}  // namespace obby::nn
