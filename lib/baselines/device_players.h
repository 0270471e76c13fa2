// Players of a learned method on a device. They share the ticks of sim's batch kernels and have
// their own kernel for observations. Host only.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "baselines/device_kernels.h"
#include "baselines/episode.h"
#include "baselines/names.h"
#include "geom/region.h"
#include "sim/batch.h"

namespace obby::baselines {

// A player's view in methods that learn during the search.
struct View {
  const Episode* player;
  geom::Region next;  // region that the player has to reach
  Turns ahead;        // heading of the observation
};

class DevicePlayers {
 public:
  // Allocates memory for up to `max` players, and copies the problem and surroundings to the
  // device. The device must outlive this object.
  Status open(sim::Device& device, const Problem& problem, const policy::SurroundingsView& around,
              uint32_t max);

  // Plays one tick of all `episodes` with `actions`. Each episode must be running. On failure they
  // are unchanged.
  Status advance(std::span<Episode* const> episodes, const sim::Action* actions);
  // Fills `inputs`, (views, policy::kInputs), whose rows begin `stride` numbers apart.
  Status see(std::span<const View> views, float* inputs, size_t stride);

 private:
  sim::Device* device_ = nullptr;
  std::unique_ptr<sim::Batch> batch_;
  SightArguments sight_{};
  sim::Memory tables_, lookerMemory_, bodyMemory_, inputMemory_;
  std::vector<sim::Action> actions_;  // (players)
  std::vector<float> inputs_;
};

}  // namespace obby::baselines
