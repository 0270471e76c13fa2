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

  // Runs rollouts from `starts` with the bodies `loose`, (rollouts, level.looseCount). ends() and
  // visits() then return their results, in that order.
  Status run(std::span<const RolloutStart> starts, std::span<const sim::LooseBody> loose);

  const std::vector<RolloutEnd>& ends() const { return ends_; }
  std::span<const RolloutVisit> visits(size_t i) const {
    return std::span(visits_).subspan(i * arguments_.room, ends_[i].visits);
  }
  std::span<const sim::LooseBody> endLoose(size_t i) const { return bodiesAt(endLoose_, i); }
  std::span<const sim::LooseBody> visitLoose(size_t i, size_t visit) const {
    return bodiesAt(visitLoose_, i * arguments_.room + visit);
  }

 private:
  std::span<const sim::LooseBody> bodiesAt(const std::vector<sim::LooseBody>& all,
                                           size_t at) const {
    const size_t count = arguments_.rules.context.level.looseCount;
    return std::span(all).subspan(at * count, count);
  }
  DeviceRollouts(sim::Device& device, const RolloutRules& rules)
      : device_(&device), arguments_{rules, visitRoom(rules), {}, {}, {}, {}, {}} {}
  Status makeRoom(size_t rollouts);

  sim::Device* device_;
  RolloutArguments arguments_;
  sim::Memory tables_, startMemory_, looseMemory_, visitMemory_, visitLooseMemory_, endMemory_;
  std::vector<RolloutEnd> ends_;
  std::vector<RolloutVisit> visits_;
  std::vector<sim::LooseBody> endLoose_, visitLoose_;
};

// `loose`: for levels with dynamic bodies.
const sim::Kernel& rolloutKernel(bool loose);

}  // namespace obby::solve
