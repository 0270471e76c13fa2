// A round's rollouts on a device that runs kernels.
#pragma once

#include <span>
#include <vector>

#include "sim/device.h"
#include "solve/rollout_kernel.h"

namespace obby::solve {

class DeviceRollouts {
 public:
  // `arguments` without its tables of starts, visits and ends.
  static Result<DeviceRollouts> open(sim::Device& device, RolloutArguments arguments);

  // Runs them all; ends() and visits() are then theirs, in the order of `starts`.
  Status run(std::span<const RolloutStart> starts);

  const std::vector<RolloutEnd>& ends() const { return ends_; }
  std::span<const RolloutVisit> visits(size_t i) const {
    return std::span(visits_).subspan(i * arguments_.room, ends_[i].visits);
  }

 private:
  DeviceRollouts(sim::Device& device, const RolloutArguments& arguments)
      : device_(&device), arguments_(arguments) {}
  Status makeRoom(size_t rollouts);

  sim::Device* device_;
  RolloutArguments arguments_;
  sim::Memory tables_, startMemory_, visitMemory_, endMemory_;
  std::vector<RolloutEnd> ends_;
  std::vector<RolloutVisit> visits_;
};

const sim::Kernel& rolloutKernel();

}  // namespace obby::solve
