// The policy on the CPU: observes and evaluates in SIMD lanes. Results have the same bits as the
// kernels', which use a single lane. Host only.
#pragma once

#include <vector>

#include "policy/decide.h"
#include "policy/surroundings.h"

namespace obby::policy {

// Normalisers, weights and biases, in one block.
class Network {
 public:
  // Means and scales of the inputs, then weights and biases of each layer (NetworkView).
  static constexpr size_t kSizes[] = {size_t(kInputs),
                                      size_t(kInputs),
                                      size_t(kInputs) * kHidden,
                                      size_t(kHidden),
                                      size_t(kHidden) * kHidden,
                                      size_t(kHidden),
                                      size_t(kHidden) * kPaddedOutputs,
                                      size_t(kPaddedOutputs)};
  static constexpr size_t kNumbers = 2 * size_t(kInputs) + size_t(kInputs) * kHidden + kHidden +
                                     size_t(kHidden) * kHidden + kHidden +
                                     size_t(kHidden) * kPaddedOutputs + kPaddedOutputs;

  Network() : numbers_(kNumbers, 0.0f) {}  // all zero, so that all allowed moves are equally likely

  std::vector<float>& numbers() { return numbers_; }  // in the order of kSizes
  const std::vector<float>& numbers() const { return numbers_; }

 private:
  std::vector<float> numbers_;
};

// A network prepared for evaluation. `network` must outlive this object and must not change.
class Thinker {
 public:
  explicit Thinker(const Network& network);
  Thinker(const Thinker&) = delete;
  Thinker& operator=(const Thinker&) = delete;

  const NetworkView& view() const { return view_; }

 private:
  NetworkView view_;
  std::vector<float> voids_, biases_;  // (kInputs), (kHidden), see NetworkView
};

// Fills `inputs` (kInputs) with the policy's observation. Returns the direction of its frame.
// `bodies` has level.bodyCount bodies.
Turns observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
              float* inputs);

// The same for a player who is to reach `next`, in a frame that looks `ahead`.
void observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
             const sim::NextRegion& next, Turns ahead, float* inputs);

// The type of the first observe(), for trials of other observations. All inputs after the first
// kStateInputs must be kEmptyInput if nothing is in sight.
using Observe = Turns (*)(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
                          float* inputs);

// Evaluates raw inputs. `outputs` (kPaddedOutputs) receives the logits and the value.
void think(const NetworkView& network, const float* inputs, float* outputs);

// Returns the action to hold for the next kDecisionTicks ticks (decide.h).
sim::Action decide(const Scene& scene, const NetworkView& network, const sim::World& world,
                   const sim::RigidBody* bodies, Random* random);

// Does the part of decide() after the observation `inputs` (kInputs), in a frame that looks
// `ahead`.
sim::Action decideOn(const Scene& scene, const NetworkView& network, const sim::World& world,
                     const float* inputs, Turns ahead, Random* random);

// A policy prepared for one level, which decide() needs in addition to a query. The level's tables
// and the network must outlive this object.
class Pilot {
 public:
  Pilot(const level::LevelView& level, const Network& network)
      : surroundings_(level, kSight), thinker_(network) {}

  // Valid while this object lives at its address.
  PilotView view() const { return {surroundings_.view(), thinker_.view()}; }

 private:
  const Surroundings surroundings_;
  const Thinker thinker_;
};

}  // namespace obby::policy
