// The policy at work on the CPU: looks, thinks, in SIMD lanes. The same bits as the kernels' one
// lane. Host only.
#pragma once

#include <vector>

#include "policy/network.h"
#include "policy/surroundings.h"

namespace obby::policy {

// The weights, in one block: what NetworkView points to.
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
  NetworkView view() const;  // valid while this object lives and stays where it is

 private:
  std::vector<float> numbers_;
};

// Fills `inputs` (kInputs) with what the policy sees; gives the direction that its frame looks in.
// `loose`: (level.looseCount).
Turns observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
              float* inputs);

// `outputs`: (kPaddedOutputs), logits and value, of raw inputs.
void think(const NetworkView& network, const float* inputs, float* outputs);

// A policy at the controls of players in one level under one query.
class Pilot {
 public:
  // The views' tables and the network must outlive it.
  Pilot(const level::LevelView& level, const level::QueryView& query, const Network& network);
  Pilot(const Pilot&) = delete;
  Pilot& operator=(const Pilot&) = delete;

  // What to hold for the next kDecisionTicks ticks: a move drawn with `random`, or the likeliest
  // where that is null. `loose`: (level.looseCount).
  sim::Action decide(const sim::World& world, const sim::LooseBody* loose, Random* random) const;

 private:
  const Surroundings surroundings_;
  const Scene scene_;
  const NetworkView network_;
};

}  // namespace obby::policy
