// The loss of proximal policy optimisation (Schulman et al. 2017) for one decision: clipped
// surrogate, value error, entropy; and its slope by the network's outputs.
#pragma once

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

constexpr float kNever = -1e6f;  // added to a logit: e^ of it is 0

// What `fold` makes of a number for each move: of eight of them side by side, so that the compiler
// makes lanes of it, then of these, in the same order everywhere.
template <class S, class Fold>
OBBY_DEVICE S folded(const S* x, Fold&& fold) {
  constexpr int kAbreast = 8;
  static_assert(kMoves >= kAbreast);
  S parts[kAbreast];
  for (int i = 0; i < kAbreast; ++i) parts[i] = x[i];
  for (int m = kAbreast; m + kAbreast <= kMoves; m += kAbreast) {
    for (int i = 0; i < kAbreast; ++i) parts[i] = fold(parts[i], x[m + i]);
  }
  constexpr int kRest = kMoves % kAbreast;
  for (int i = 0; i < kRest; ++i) parts[i] = fold(parts[i], x[kMoves - kRest + i]);
  for (int half = kAbreast / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) parts[i] = fold(parts[i], parts[i + half]);
  }
  return parts[0];
}

template <class S>
OBBY_DEVICE S sumOf(const S* x) {
  return folded(x, [](S a, S b) OBBY_INLINED { return a + b; });
}

// Probabilities of the moves; those that are not allowed (isAllowed) get 0. `chances`: (kMoves). No
// branch in a loop, so that the compiler makes lanes of them.
template <class S>
OBBY_DEVICE void chancesOf(const S* logits, bool mayJump, S* chances) {
  const S jumping = mayJump ? S(0) : S(kNever);
  for (int m = 0; m < kMoves; ++m) chances[m] = logits[m] + jumping * S(jumps(m) ? 1 : 0);
  const S most = folded(chances, [](S a, S b) OBBY_INLINED { return a < b ? b : a; });
  for (int m = 0; m < kMoves; ++m) chances[m] = expNegative(chances[m] - most);
  const S sum = sumOf(chances);
  for (int m = 0; m < kMoves; ++m) chances[m] /= sum;
}

// A move drawn, and the logarithm of its chance.
struct Drawn {
  int move;
  float logChance;
};

// `draw`: uniform over [0, 1).
OBBY_DEVICE Drawn drawMove(const float* logits, bool mayJump, float draw) {
  float chances[kMoves];
  chancesOf(logits, mayJump, chances);
  int move = 0;
  for (int m = 0; m < kMoves && draw >= 0; ++m) {
    if (!(chances[m] > 0)) continue;
    move = m;
    draw -= chances[m];
  }
  return {move, logOf(chances[move])};
}

// `outputs`, `slope`: (kPaddedOutputs). Slopes of what is padding are 0.
template <class S>
OBBY_DEVICE LossOf<S> lossOf(const S* outputs, const Decision& d, const LossSettings& settings,
                             S* slope) {
  S p[kMoves], logs[kMoves], parts[kMoves];
  chancesOf(outputs, d.mayJump, p);
  LossOf<S> r;
  for (int m = 0; m < kMoves; ++m) logs[m] = logOf(p[m]);  // of 0: some number that nobody uses
  for (int m = 0; m < kMoves; ++m) parts[m] = p[m] > 0 ? p[m] * logs[m] : S(0);
  r.entropy = -sumOf(parts);
  const S logRatio = logs[d.move] - S(d.logChance), ratio = expOf(logRatio);
  const S a = S(d.advantage), clip = S(settings.clip);
  const S floor = ratio < 1 - clip ? 1 - clip : ratio;
  const S plain = ratio * a, bounded = (1 + clip < floor ? 1 + clip : floor) * a;
  r.clipped = bounded < plain;
  r.divergence = ratio - 1 - logRatio;
  r.valueError = outputs[kMoves] - S(d.target);
  r.loss = -(bounded < plain ? bounded : plain) +
           S(settings.valueShare) * r.valueError * r.valueError / 2 -
           S(settings.entropyShare) * r.entropy;
  const S pull = r.clipped ? S(0) : -ratio * a;  // by the log chance of the move
  const S share = S(settings.entropyShare), common = share * r.entropy - pull;
  for (int m = 0; m < kMoves; ++m) {
    const S along = p[m] * (share * logs[m] + common);
    slope[m] = p[m] > 0 ? along : S(0);
  }
  if (p[d.move] > 0) slope[d.move] += pull;
  for (int m = kMoves; m < kPaddedOutputs; ++m) slope[m] = 0;
  slope[kMoves] = S(settings.valueShare) * r.valueError;
  return r;
}

}  // namespace obby::policy
