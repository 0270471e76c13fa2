// The policy's moves as a distribution, and the losses of one decision by the network's outputs.
// Templates on the number type.
#pragma once

#include "nn/losses.h"
#include "policy/moves.h"
#include "policy/pilot_view.h"

namespace obby::policy {

// A decision as it was made.
struct Decision : nn::PpoDecision {
  bool mayJump;
};

// Fills `p`, (kMoves), with the probabilities of the moves. Moves that are not allowed (isAllowed)
// get 0.
template <class S>
OBBY_DEVICE void probabilitiesOf(const S* logits, bool mayJump, S* p) {
  const S jumping = mayJump ? S(0) : S(nn::kBarred);
  nn::softmax<kMoves>(
      logits, [jumping](int m) OBBY_INLINED { return jumping * S(jumps(m) ? 1 : 0); }, p);
}

// Draws a move. `draw`: uniform over [0, 1).
OBBY_DEVICE nn::Drawn drawMove(const float* logits, bool mayJump, float draw) {
  float p[kMoves];
  probabilitiesOf(logits, mayJump, p);
  return nn::drawAction<kMoves>(p, draw);
}

// Returns the PPO loss of a decision. `outputs`, `gradient`: (kPaddedOutputs). The gradient of
// padding is 0.
template <class S>
OBBY_DEVICE nn::PpoLoss<S> ppoLossOf(const S* outputs, const Decision& d,
                                     const nn::PpoLossSettings& settings, S* gradient) {
  S p[kMoves];
  probabilitiesOf(outputs, d.mayJump, p);
  for (int m = kMoves + 1; m < kPaddedOutputs; ++m) gradient[m] = 0;
  return nn::ppoLoss<kMoves>(p, outputs[kMoves], d, settings, gradient, gradient[kMoves]);
}

// Returns the loss of imitating the decision, whose target is the return that followed it. The loss
// is 0 if the return is no more than expected.
template <class S>
S imitationLossOf(const S* outputs, const Decision& d, S weight, S valueWeight, S* gradient) {
  for (int m = 0; m < kPaddedOutputs; ++m) gradient[m] = 0;
  const S better = S(d.target) - outputs[kMoves];
  if (!(better > 0)) return 0;
  S p[kMoves];
  probabilitiesOf(outputs, d.mayJump, p);
  return nn::imitationLoss<kMoves>(p, d.action, better, weight, valueWeight, gradient,
                                   gradient[kMoves]);
}

}  // namespace obby::policy
