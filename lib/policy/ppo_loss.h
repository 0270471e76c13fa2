// The loss of proximal policy optimisation (Schulman et al. 2017) for one decision: clipped
// surrogate, value error, entropy; and its slope by the network's outputs.
#pragma once

#include <algorithm>
#include <limits>

#include "policy/exponential_double.h"
#include "policy/moves.h"
#include "policy/network.h"

namespace obby::policy {

struct LossSettings {
  float clip = 0.2f;
  float valueShare = 0.5f;
  float entropyShare = 0.01f;
};

// A decision as it was made.
struct Decision {
  int move;
  bool mayJump;
  float logChance;  // of the move, then
  float advantage;  // normalised
  float target;     // of the value, in the value head's units
};

template <class S>
struct LossOf {
  S loss = 0, entropy = 0, valueError = 0;
  S divergence = 0;  // estimate of KL(old, new): r - 1 - log r
  bool clipped = false;
};

// Probabilities of the moves; those that are not allowed get 0. `chances`: (kMoves).
template <class S>
void chancesOf(const S* logits, bool mayJump, S* chances) {
  S most = -std::numeric_limits<S>::infinity(), sum = 0;
  for (int m = 0; m < kMoves; ++m) {
    if (!jumps(m) || mayJump) most = std::max(most, logits[m]);
  }
  for (int m = 0; m < kMoves; ++m) {
    chances[m] = !jumps(m) || mayJump ? expOf(logits[m] - most) : S(0);
    sum += chances[m];
  }
  for (int m = 0; m < kMoves; ++m) chances[m] /= sum;
}

// `outputs`, `slope`: (kPaddedOutputs). Slopes of what is padding are 0.
template <class S>
LossOf<S> lossOf(const S* outputs, const Decision& d, const LossSettings& settings, S* slope) {
  S p[kMoves];
  chancesOf(outputs, d.mayJump, p);
  LossOf<S> r;
  for (const S c : p) r.entropy -= c > 0 ? c * logOf(c) : S(0);
  const S logRatio = logOf(p[d.move]) - S(d.logChance), ratio = expOf(logRatio);
  const S a = S(d.advantage), clip = S(settings.clip);
  const S plain = ratio * a, bounded = std::min(std::max(ratio, 1 - clip), 1 + clip) * a;
  r.clipped = bounded < plain;
  r.divergence = ratio - 1 - logRatio;
  r.valueError = outputs[kMoves] - S(d.target);
  r.loss = -std::min(plain, bounded) + S(settings.valueShare) * r.valueError * r.valueError / 2 -
           S(settings.entropyShare) * r.entropy;
  const S pull = r.clipped ? S(0) : -ratio * a;  // by the log chance of the move
  for (int m = 0; m < kPaddedOutputs; ++m) slope[m] = 0;
  for (int m = 0; m < kMoves; ++m) {
    if (!(p[m] > 0)) continue;
    slope[m] = pull * ((m == d.move ? S(1) : S(0)) - p[m]) +
               S(settings.entropyShare) * p[m] * (logOf(p[m]) + r.entropy);
  }
  slope[kMoves] = S(settings.valueShare) * r.valueError;
  return r;
}

}  // namespace obby::policy
