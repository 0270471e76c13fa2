// Runs the rollouts of a round on a device that runs kernels.
#pragma once

#include <span>
#include <vector>

#include "sim/device.h"
#include "solve/search/rollouts/rollout_kernel.h"

namespace obby::solve {

class DeviceRollouts {
 public:
  static Result<DeviceRollouts> open(sim::Device& device, const RolloutRules& rules);

  // Runs rollouts from `starts` with `bodies`: (rollouts, level.bodyCount). ends() and visits()
  // then return their results, in that order.
  Status run(std::span<const RolloutStart> starts, std::span<const sim::RigidBody> bodies);

  const std::vector<RolloutEnd>& ends() const { return ends_; }
  std::span<const RolloutVisit> visits(size_t i) const {
    return std::span(visits_).subspan(i * arguments_.capacity, ends_[i].visits);
  }
  std::span<const sim::RigidBody> endBodies(size_t i) const { return bodiesAt(endBodies_, i); }
  std::span<const sim::RigidBody> visitBodies(size_t i, size_t visit) const {
    return bodiesAt(visitBodies_, i * arguments_.capacity + visit);
  }

 private:
  std::span<const sim::RigidBody> bodiesAt(const std::vector<sim::RigidBody>& all,
                                           size_t at) const {
    const size_t count = arguments_.rules.context.level.bodyCount;
    return std::span(all).subspan(at * count, count);
  }
  DeviceRollouts(sim::Device& device, const RolloutRules& rules)
      : device_(&device), arguments_{rules, visitCapacity(rules), {}, {}, {}, {}, {}} {}
  Status reserve(size_t rollouts);

  sim::Device* device_;
  RolloutArguments arguments_;
  sim::Memory tables_, startMemory_, bodyMemory_, visitMemory_, visitBodyMemory_, endMemory_;
  std::vector<RolloutEnd> ends_;
  std::vector<RolloutVisit> visits_;
  std::vector<sim::RigidBody> endBodies_, visitBodies_;
};

// `bodies`: for levels with dynamic bodies.
const sim::Kernel& rolloutKernel(bool bodies);

}  // namespace obby::solve
