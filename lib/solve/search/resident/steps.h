// Names the kernels of a resident search.
#pragma once

#include "sim/kernel.h"

namespace obby::solve {

enum class ResidentStep {
  weigh,
  countRanks,
  sumRanks,
  markBest,
  choose,
  explore,
  exploreDynamic,  // for levels with dynamic bodies
  takePlayed,
  claim,
  settle,
  count,
  sumFinds,
  place,
  sum,     // takes SumArguments; all above take ResidentArguments
  rehash,  // takes RehashArguments
};

const sim::Kernel& residentKernel(ResidentStep step);

}  // namespace obby::solve
