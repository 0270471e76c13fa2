// Losses of one row, and their gradients with respect to the network's outputs. They are templates
// on the number type, so that tests can compare gradients with finite differences in double
// precision.
#pragma once

#include "nn/categorical.h"

namespace obby::nn {

struct PpoLossSettings {
  float clip = 0.2f;
  float valueWeight = 0.5f;
  float entropyWeight = 0.01f;
};

// A decision of the behaviour policy, as PPO needs it.
struct PpoDecision {
  int action;
  float logProbability;  // log probability of the action at the time of the decision
  float advantage;       // normalised
  float target;          // value target, in the value head's units
};

template <class S>
struct PpoLoss {
  S loss = 0, entropy = 0, valueError = 0;
  S approxKl = 0;  // estimate of KL(old, new): r - 1 - log r (Schulman 2020)
  bool clipped = false;
};

// Proximal policy optimisation (Schulman et al. 2017): clipped surrogate, value error, entropy.
// `p`: (kCount), from softmax(); `logitGradient`: (kCount).
template <int kCount, class S>
OBBY_DEVICE PpoLoss<S> ppoLoss(const S* p, S value, const PpoDecision& d,
                               const PpoLossSettings& settings, S* logitGradient,
                               S& valueGradient) {
  S logs[kCount], parts[kCount];
  PpoLoss<S> r;
  for (int m = 0; m < kCount; ++m) logs[m] = logOf(p[m]);  // finite for 0, and then unused
  for (int m = 0; m < kCount; ++m) parts[m] = p[m] > 0 ? p[m] * logs[m] : S(0);
  r.entropy = -sumOf<kCount>(parts);
  const S logRatio = logs[d.action] - S(d.logProbability), ratio = expOf(logRatio);
  const S a = S(d.advantage), clip = S(settings.clip);
  const S floor = ratio < 1 - clip ? 1 - clip : ratio;
  const S plain = ratio * a, bounded = (1 + clip < floor ? 1 + clip : floor) * a;
  const S valueWeight = S(settings.valueWeight), entropyWeight = S(settings.entropyWeight);
  r.clipped = bounded < plain;
  r.approxKl = ratio - 1 - logRatio;
  r.valueError = value - S(d.target);
  r.loss = -(bounded < plain ? bounded : plain) + valueWeight * r.valueError * r.valueError / 2 -
           entropyWeight * r.entropy;
  const S pull = r.clipped ? S(0) : -ratio * a;  // gradient by the action's log probability
  const S common = entropyWeight * r.entropy - pull;
  for (int m = 0; m < kCount; ++m) {
    const S along = p[m] * (entropyWeight * logs[m] + common);
    logitGradient[m] = p[m] > 0 ? along : S(0);
  }
  if (p[d.action] > 0) logitGradient[d.action] += pull;
  valueGradient = valueWeight * r.valueError;
  return r;
}

// Self-imitation (Oh et al. 2018) of a decision from a kept trajectory. It raises the action's
// probability and the state's value in proportion to `better`, by which the return exceeds the
// estimate. `better` is positive, and counts as constant in the policy gradient.
template <int kCount, class S>
S imitationLoss(const S* p, int action, S better, S weight, S valueWeight, S* logitGradient,
                S& valueGradient) {
  for (int m = 0; m < kCount; ++m)
    logitGradient[m] = weight * better * (p[m] - (m == action ? S(1) : S(0)));
  valueGradient = -weight * valueWeight * better;
  return weight * (-logOf(p[action]) * better + valueWeight * better * better / 2);
}

// Returns the cross-entropy of predicting `action`.
template <int kCount, class S>
S crossEntropy(const S* p, int action, S* logitGradient) {
  for (int m = 0; m < kCount; ++m) logitGradient[m] = p[m];
  logitGradient[action] -= 1;
  return -logOf(p[action]);
}

// Quantile regression (QR-DQN, Dabney et al. 2018). Weighted Huber losses make each prediction a
// quantile of the targets. All three arrays: (kQuantiles).
template <int kQuantiles, class S>
S quantileLoss(const S* predicted, const S* targets, S* gradient) {
  S loss = 0;
  for (int i = 0; i < kQuantiles; ++i) {
    const S quantile = S(2 * i + 1) / S(2 * kQuantiles);
    gradient[i] = 0;
    for (int j = 0; j < kQuantiles; ++j) {
      const S error = targets[j] - predicted[i], size = error < 0 ? -error : error;
      const S weight = (error < 0 ? 1 - quantile : quantile) / S(kQuantiles);
      const bool near = size <= 1;
      loss += weight * (near ? error * error / 2 : size - S(0.5));
      gradient[i] -= weight * (near ? error : error / size);
    }
  }
  return loss;
}

}  // namespace obby::nn
