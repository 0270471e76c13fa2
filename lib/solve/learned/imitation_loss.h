// The loss of self-imitation (Oh et al. 2018) for one decision that a kept playthrough made: to
// make it likelier, and its state to be worth more, as far as it did better than expected.
#pragma once

#include "policy/ppo_loss.h"

namespace obby::solve::learned {

// `outputs`, `slope`: (kPaddedOutputs). Of the decision: its move, and what came of it as target.
// How much better that was counts as a constant in the slope of the move's likelihood.
template <class S>
S imitationLoss(const S* outputs, const policy::Decision& d, S share, S valueShare, S* slope) {
  using policy::kMoves;
  for (int m = 0; m < policy::kPaddedOutputs; ++m) slope[m] = 0;
  const S better = S(d.target) - outputs[kMoves];
  if (!(better > 0)) return 0;
  S p[kMoves];
  policy::chancesOf(outputs, d.mayJump, p);
  for (int m = 0; m < kMoves; ++m) slope[m] = share * better * (p[m] - (m == d.move ? S(1) : S(0)));
  slope[kMoves] = -share * valueShare * better;
  return share * (-logOf(p[d.move]) * better + valueShare * better * better / 2);
}

}  // namespace obby::solve::learned
