// Levels brought to a device together: one piece of memory and one copy for all of them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/thread_pool.h"
#include "sim/device.h"
#include "train/device/play_kernels.h"
#include "train/training_level.h"

namespace obby::train {

struct Delivery {
  std::shared_ptr<const sim::Memory> memory;  // of all of them
  std::vector<DevicePlace> places;            // one a level; with room for their worlds' bodies
};

// Beside what the device does. `patience`: as EnvGroupSettings::patience; `worlds`: on each level.
// The error is the device's.
Result<Delivery> deliver(sim::Device& device, std::span<const TrainingLevel* const> levels,
                         float patience, uint32_t worlds, ThreadPool& pool);

}  // namespace obby::train
