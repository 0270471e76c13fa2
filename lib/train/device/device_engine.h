// Training on a device. Worlds, batch and network stay in the device's memory. The host makes the
// next levels while the current ones are played.
#pragma once

#include "train/device/device_ranks.h"
#include "train/engine.h"

namespace obby::train {

// The arguments must outlive the engine. `direct`: exchange of gradients between ranks; null:
// through the host.
std::unique_ptr<Engine> makeDeviceEngine(const TrainerSettings& settings, const LevelSource& source,
                                         sim::Device& device, ThreadPool& pool, Ranks& ranks,
                                         DeviceRanks* direct = nullptr);

// Returns the engine for `device`, or for the CPU if `device` is null.
std::unique_ptr<Engine> makeEngine(const TrainerSettings& settings, const LevelSource& source,
                                   sim::Device* device, ThreadPool& pool, Ranks& ranks,
                                   DeviceRanks* direct);

}  // namespace obby::train
