// The training kernels on a device, apart from those of lib/nn, by name. OBBY_TRAIN_KERNELS is
// their only list.
#pragma once

#include "sim/kernel.h"

// X(name, arguments, function). The first list has the kernels that simulate worlds.
#define OBBY_PLAY_KERNELS(X)           \
  X(act, PlayArguments, actOne<false>) \
  X(actDynamic, PlayArguments, actOne<true>)
#define OBBY_LEARN_KERNELS(X)                 \
  X(observe, PlayArguments, observeWorld)     \
  X(countInputs, PlayArguments, countInputs)  \
  X(normalise, PlayArguments, normaliseInput) \
  X(expect, PlayArguments, expectValue)       \
  X(settle, PlayArguments, settlePlace)       \
  X(begin, PlayArguments, beginPlace)         \
  X(gather, MinibatchArguments, gatherInputs) \
  X(loss, MinibatchArguments, lossOfPlace)    \
  X(rescale, RescaleArguments, rescaleOne)
#define OBBY_TRAIN_KERNELS(X) OBBY_PLAY_KERNELS(X) OBBY_LEARN_KERNELS(X)

namespace obby::train {

enum class TrainStep {
#define OBBY_TRAIN_STEP(name, arguments, function) name,
  OBBY_TRAIN_KERNELS(OBBY_TRAIN_STEP)
#undef OBBY_TRAIN_STEP
};

const sim::Kernel& trainKernel(TrainStep step);

}  // namespace obby::train
