// A policy at the controls: observes, evaluates the network and picks a move. The templates take a
// number type; the bits are the same for every number of lanes.
#pragma once

#include "policy/moves.h"
#include "policy/network.h"

namespace obby::policy {

// Returns the action to hold for the next kDecisionTicks ticks: a move drawn with `random`, or the
// likeliest move if that is null. `inputs` (kInputs) are an observation in a frame that looks
// `ahead`.
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

// Does the same after a new observation. `bodies` has level.bodyCount bodies.
template <class F>
OBBY_DEVICE sim::Action decide(const Scene& scene, const NetworkView& network,
                               const sim::World& world, const sim::RigidBody* bodies,
                               Random* random) {
  float inputs[kInputs];
  const Turns ahead = observe<F>(scene, world, bodies, inputs);
  return decideOn<F>(scene, network, world, inputs, ahead, random);
}

}  // namespace obby::policy
