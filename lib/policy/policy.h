// The policy at work on the CPU: looks, thinks, in SIMD lanes. The same bits as the kernels' one
// lane. Host only.
#pragma once

#include <vector>

#include "policy/decide.h"
#include "policy/surroundings.h"

namespace obby::policy {

// Normalisers, weights and biases, in one block.
class Network {
 public:
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

  Network() : numbers_(kNumbers, 0.0f) {}  // all zero: every allowed move alike

  std::vector<float>& numbers() { return numbers_; }  // in the order of kSizes
  const std::vector<float>& numbers() const { return numbers_; }

 private:
  std::vector<float> numbers_;
};

// A network as it thinks. `network` must outlive it, and keep its numbers.
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

// Fills `inputs` (kInputs) with what the policy sees; gives the direction that its frame looks in.
// `loose`: (level.looseCount).
Turns observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
              float* inputs);

// The same of a player who is to reach `next`, in a frame that looks `ahead`.
void observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
             const sim::NextRegion& next, Turns ahead, float* inputs);

// The first of them, or another way to see, to be tried: all inputs but the first kStateInputs are
// kEmptyInput where nothing is in sight.
using Observe = Turns (*)(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
                          float* inputs);

// `outputs`: (kPaddedOutputs), logits and value, of raw inputs.
void think(const NetworkView& network, const float* inputs, float* outputs);

// What to hold for the next kDecisionTicks ticks, as decide.h has it.
sim::Action decide(const Scene& scene, const NetworkView& network, const sim::World& world,
                   const sim::LooseBody* loose, Random* random);

// What decide() does once it has seen `inputs` (kInputs) in a frame that looks `ahead`.
sim::Action decideOn(const Scene& scene, const NetworkView& network, const sim::World& world,
                     const float* inputs, Turns ahead, Random* random);

// A policy made ready for one level: what decide() needs beside it and a query. The level's tables
// and the network must outlive it.
class Pilot {
 public:
  Pilot(const level::LevelView& level, const Network& network)
      : surroundings_(level, kSight), thinker_(network) {}

  // Valid while this object lives and stays where it is.
  PilotView view() const { return {surroundings_.view(), thinker_.view()}; }

 private:
  const Surroundings surroundings_;
  const Thinker thinker_;
};

}  // namespace obby::policy
