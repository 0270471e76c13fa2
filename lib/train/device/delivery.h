// Uploads several levels to a device with one allocation and one copy.
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
  std::shared_ptr<const sim::Memory> memory;  // holds all levels
  std::vector<DevicePlace> places;            // one per level, with memory for bodies
};

// Uploads levels while the device works. `patience`: as EnvGroupSettings::patience; `worlds`:
// number of worlds on each level. Errors: the device's.
Result<Delivery> deliver(sim::Device& device, std::span<const TrainingLevel* const> levels,
                         float patience, uint32_t worlds, ThreadPool& pool);

}  // namespace obby::train
