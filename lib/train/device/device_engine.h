// Learning on a device that runs kernels: worlds, batch and network stay there, and the host makes
// the levels that come next while they are played.
#pragma once

#include "train/device/device_ranks.h"
#include "train/engine.h"

namespace obby::train {

// What it refers to must outlive it. `direct`: how ranks exchange gradients; null: through the
// host.
std::unique_ptr<Engine> makeDeviceEngine(const TrainerSettings& settings, const LevelSource& source,
                                         sim::Device& device, ThreadPool& pool, Ranks& ranks,
                                         DeviceRanks* direct = nullptr);

}  // namespace obby::train
