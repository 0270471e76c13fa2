// A policy at the controls: looks, thinks, picks a move. Templates on the number type; every number
// of lanes gives the same bits.
#pragma once

#include "policy/moves.h"
#include "policy/network.h"

namespace obby::policy {

// What to hold for the next kDecisionTicks ticks: a move drawn with `random`, or the likeliest
// where that is null. `loose`: (level.looseCount).
template <class F>
OBBY_DEVICE sim::Action decide(const Scene& scene, const NetworkView& network,
                               const sim::World& world, const sim::LooseBody* loose,
                               Random* random) {
  float inputs[kInputs], outputs[kPaddedOutputs];
  const Turns ahead = observe<F>(scene, world, loose, inputs);
  think<F>(network, inputs, outputs);
  const bool mayJump = jumpAllowed(scene, world);
  const int move =
      random == nullptr ? likeliest(outputs, mayJump) : draw(outputs, mayJump, *random);
  return actionOf(move, ahead);
}

}  // namespace obby::policy
