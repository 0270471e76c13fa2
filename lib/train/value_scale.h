// The scale of the value head. The head learns returns of mean 0 and deviation 1. When the scale
// changes, the head's weights change so that its values stay the same (Pop-Art, van Hasselt et al.
// 2016).
#pragma once

#include <algorithm>

#include "train/normaliser.h"

namespace obby::train {

struct ValueScale {
  float mean = 0, deviation = 1;  // a return, in rewards, is mean + deviation x output
  Sums returns{1};

  // Adds the returns of another batch of this rank.
  void take(Sums now, Ranks& ranks) {
    constexpr double kFade = 0.95;  // weight of earlier returns, per batch
    constexpr float kMin = 1e-3f;
    returns.fade(kFade);
    now.add(ranks);
    returns.add(now);
    mean = float(returns.mean(0));
    deviation = std::max(float(returns.deviation(0)), kMin);
  }
};

}  // namespace obby::train
