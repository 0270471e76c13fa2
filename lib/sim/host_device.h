// Runs kernels on the CPU in place of a GPU, one index after another, with separate memory. Tests
// use it to check uploads and kernels without a GPU. For speed, use the lanes of makeCpuBatch.
#pragma once

#include "base/thread_pool.h"
#include "sim/device.h"

namespace obby::sim {

class HostDevice : public Device {
 public:
  // The pool must outlive the device.
  explicit HostDevice(ThreadPool& pool) : pool_(pool) {}

  std::string name() const override { return "CPU in place of a GPU"; }
  Result<void*> allocate(size_t bytes) override;
  void release(void* memory) override;
  Status upload(void* to, const void* from, size_t bytes) override;
  Status uploadAside(void* to, const void* from, size_t bytes) override {
    return upload(to, from, bytes);
  }
  Status download(void* to, const void* from, size_t bytes) const override;
  Status copy(void* to, const void* from, size_t bytes) override;
  Status fill(void* to, uint8_t value, size_t bytes) override;
  Status launch(const Kernel& kernel, const void* arguments, uint32_t count) override;
  Result<KernelFacts> facts(const Kernel& kernel) const override;

 private:
  ThreadPool& pool_;
};

}  // namespace obby::sim
