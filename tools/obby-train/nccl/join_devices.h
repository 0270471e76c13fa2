// How ranks that learn on GPUs exchange gradients without the host.
#pragma once

#include <memory>

#include "train/device/device_ranks.h"

namespace obby::tools {

// After each rank has opened its GPU. Null: through the host, as where there is one rank or no
// NCCL. Every rank calls it. Error: NCCL's own words, the same on every rank.
Result<std::unique_ptr<train::DeviceRanks>> joinDevices(train::Ranks& ranks);

}  // namespace obby::tools
