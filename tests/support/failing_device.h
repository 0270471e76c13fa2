// A device whose launches fail after a given number of them.
#pragma once

#include "sim/host_device.h"

namespace obby::support {

class FailingDevice : public sim::HostDevice {
 public:
  FailingDevice(ThreadPool& pool, int launches) : HostDevice(pool), left_(launches) {}
  Status launch(const sim::Kernel& kernel, const void* arguments, uint32_t count) override {
    if (left_-- <= 0) return makeError("CUDA: rollout: unspecified launch failure");
    return HostDevice::launch(kernel, arguments, count);
  }

 private:
  int left_;
};

}  // namespace obby::support
