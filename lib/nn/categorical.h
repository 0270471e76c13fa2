// A categorical distribution over kCount actions, some of which may be masked. Templates on the
// number type. Sums have the same order on every machine.
#pragma once

#include "math/exponential.h"

namespace obby {

// In double precision, by libm, and on the host only: tests compare the gradients of the templates
// with finite differences. No result of a program depends on these.
inline double expNegative(double x) { return __builtin_exp(x); }
inline double expOf(double x) { return __builtin_exp(x); }
inline double logOf(double x) { return __builtin_log(x); }

}  // namespace obby

namespace obby::nn {

constexpr float kBarred = -1e6f;  // added to a masked logit: its exponential is 0

// Folds the numbers of all actions into one. Eight independent partial results let the compiler
// vectorise. They are folded last, in the same order on every machine.
template <int kCount, class S, class Fold>
OBBY_DEVICE S folded(const S* x, Fold&& fold) {
  constexpr int kAbreast = 8;
  static_assert(kCount >= kAbreast);
  S parts[kAbreast];
  for (int i = 0; i < kAbreast; ++i) parts[i] = x[i];
  for (int m = kAbreast; m + kAbreast <= kCount; m += kAbreast) {
    for (int i = 0; i < kAbreast; ++i) parts[i] = fold(parts[i], x[m + i]);
  }
  constexpr int kRest = kCount % kAbreast;
  for (int i = 0; i < kRest; ++i) parts[i] = fold(parts[i], x[kCount - kRest + i]);
  for (int half = kAbreast / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) parts[i] = fold(parts[i], parts[i + half]);
  }
  return parts[0];
}

template <int kCount, class S>
OBBY_DEVICE S sumOf(const S* x) {
  return folded<kCount>(x, [](S a, S b) OBBY_INLINED { return a + b; });
}

// Fills `p`, (kCount), with the probabilities of the actions. `penalty(m)` is added to a logit: 0,
// or kBarred. The loops have no branches, so that the compiler can vectorise them.
template <int kCount, class S, class Penalty>
OBBY_DEVICE void softmax(const S* logits, Penalty&& penalty, S* p) {
  for (int m = 0; m < kCount; ++m) p[m] = logits[m] + penalty(m);
  const S max = folded<kCount>(p, [](S a, S b) OBBY_INLINED { return a < b ? b : a; });
  for (int m = 0; m < kCount; ++m) p[m] = expNegative(p[m] - max);
  const S sum = sumOf<kCount>(p);
  for (int m = 0; m < kCount; ++m) p[m] /= sum;
}

// A sampled action and its log probability.
struct Drawn {
  int action;
  float logProbability;
};

// Returns the action at `draw`, in [0, 1), of the cumulative distribution.
template <int kCount>
OBBY_DEVICE Drawn drawAction(const float* p, float draw) {
  int action = 0;
  for (int m = 0; m < kCount && draw >= 0; ++m) {
    if (!(p[m] > 0)) continue;
    action = m;
    draw -= p[m];
  }
  return {action, logOf(p[action])};
}

}  // namespace obby::nn
