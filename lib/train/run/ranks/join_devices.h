// The exchange of gradients between ranks on GPUs, without the host.
#pragma once

#include <memory>

#include "train/device/device_ranks.h"

namespace obby::train {

// Every rank calls this after opening its GPU. Returns null if gradients go through the host: a
// single rank, or a build without NCCL. Error: that of NCCL, the same on every rank.
Result<std::unique_ptr<DeviceRanks>> joinDevices(Ranks& ranks);

}  // namespace obby::train
