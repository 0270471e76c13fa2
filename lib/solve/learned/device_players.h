// Players of a method that learns while it searches, on a device: their ticks by the kernels of a
// batch, what they see by one of its own. Host only.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/batch.h"
#include "solve/learned/device_kernels.h"
#include "solve/learned/view.h"

namespace obby::solve::learned {

class DevicePlayers {
 public:
  // For at most so many players at once. The device must outlive this object; problem and
  // surroundings are copied to it.
  Status open(sim::Device& device, const Problem& problem, const policy::SurroundingsView& around,
              uint32_t most);

  // One tick of all `episodes` under `actions`, where each is running. They are as they were
  // where it fails.
  Status advance(std::span<Episode* const> episodes, const sim::Action* actions);
  // Fills `inputs`, (views, policy::kInputs), rows `stride` numbers apart.
  Status see(std::span<const View> views, float* inputs, size_t stride);

 private:
  sim::Device* device_ = nullptr;
  std::unique_ptr<sim::Batch> batch_;
  SightArguments sight_{};
  sim::Memory tables_, lookerMemory_, looseMemory_, inputMemory_;
  std::vector<sim::Action> actions_;  // (players)
  std::vector<float> inputs_;
};

}  // namespace obby::solve::learned
