// A policy at the controls: looks, thinks, picks a move. Templates on the number type; every number
// of lanes gives the same bits.
#pragma once

#include "policy/moves.h"
#include "policy/network.h"

namespace obby::policy {

// What to hold for the next kDecisionTicks ticks, by what was seen: a move drawn with `random`, or
// the likeliest where that is null. `inputs`: (kInputs), in a frame that looks `ahead`.
template <class F>
OBBY_DEVICE sim::Action decideOn(const Scene& scene, const NetworkView& network,
                                 const sim::World& world, const float* inputs, Turns ahead,
                                 Random* random) {
  float outputs[kPaddedOutputs];
  think<F>(network, inputs, outputs);
  const bool mayJump = jumpAllowed(scene, world);
  const int move =
      random == nullptr ? likeliest(outputs, mayJump) : draw<F>(outputs, mayJump, *random);
  return actionOf(move, ahead);
}

// The same, looking first. `loose`: (level.looseCount).
template <class F>
OBBY_DEVICE sim::Action decide(const Scene& scene, const NetworkView& network,
                               const sim::World& world, const sim::LooseBody* loose,
                               Random* random) {
  float inputs[kInputs];
  const Turns ahead = observe<F>(scene, world, loose, inputs);
  return decideOn<F>(scene, network, world, inputs, ahead, random);
}

}  // namespace obby::policy
