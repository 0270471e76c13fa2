// The kernels of a resident search by name.
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
  exploreLoose,  // for levels with loose bodies
  takePlayed,
  claim,
  settle,
  count,
  sumFinds,
  place,
  sum,     // of SumArguments, all others of ResidentArguments,
  rehash,  // but this of RehashArguments
};

const sim::Kernel& residentKernel(ResidentStep step);

}  // namespace obby::solve
