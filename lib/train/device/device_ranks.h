// Exchange of gradients between ranks that train on devices.
#pragma once

#include "sim/device.h"
#include "train/ranks.h"

namespace obby::train {

class DeviceRanks {
 public:
  virtual ~DeviceRanks() = default;
  // Gathers the gradients of all ranks. `mine`: (count) on this rank's device. `all`: (ranks,
  // count) on the same device, equal on all ranks. Every rank makes the same calls in the same
  // order.
  virtual Status gather(sim::Device& device, const float* mine, size_t count, float* all) = 0;
};

// Exchanges through host memory.
class HostRanks : public DeviceRanks {
 public:
  explicit HostRanks(Ranks& ranks) : ranks_(ranks) {}

  Status gather(sim::Device& device, const float* mine, size_t count, float* all) override {
    OBBY_ASSIGN(const std::vector<float> here, sim::downloadTable(device, mine, count));
    std::vector<float> everywhere(count * ranks_.count());
    ranks_.exchange(here.data(), count * sizeof(float), everywhere.data());
    return device.upload(all, everywhere.data(), everywhere.size() * sizeof(float));
  }

 private:
  Ranks& ranks_;
};

}  // namespace obby::train
