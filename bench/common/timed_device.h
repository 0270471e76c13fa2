// A device that waits for each kernel and records its time, to profile a loop. Waiting slows the
// loop, so rates are measured without it. A kernel's time includes a copy that another thread runs
// during it.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/report.h"
#include "sim/device.h"

namespace obby::bench {

class TimedDevice : public sim::Device {
 public:
  struct Time {
    double seconds = 0;
    uint64_t launches = 0;
  };

  // `device` must outlive this object.
  explicit TimedDevice(sim::Device& device) : device_(device) {}

  // Returns the times by kernel name, longest first.
  std::vector<std::pair<std::string, Time>> times() const {
    std::vector<std::pair<std::string, Time>> all(times_.begin(), times_.end());
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.second.seconds > b.second.seconds; });
    return all;
  }
  void forget() { times_.clear(); }

  Status launch(const sim::Kernel& kernel, const void* arguments, uint32_t count) override {
    Time& time = times_[kernel.name];
    ++time.launches;
    Status said;
    time.seconds += secondsOf([&] { said = device_.launch(kernel, arguments, count); });
    return said;
  }

  std::string name() const override { return device_.name(); }
  Result<void*> allocate(size_t bytes) override { return device_.allocate(bytes); }
  void release(void* memory) override { device_.release(memory); }
  Status upload(void* to, const void* from, size_t bytes) override {
    return device_.upload(to, from, bytes);
  }
  Status uploadAside(void* to, const void* from, size_t bytes) override {
    return device_.uploadAside(to, from, bytes);
  }
  Status download(void* to, const void* from, size_t bytes) const override {
    return device_.download(to, from, bytes);
  }
  Status copy(void* to, const void* from, size_t bytes) override {
    return device_.copy(to, from, bytes);
  }
  Status fill(void* to, uint8_t value, size_t bytes) override {
    return device_.fill(to, value, bytes);
  }
  Result<sim::KernelFacts> facts(const sim::Kernel& kernel) const override {
    return device_.facts(kernel);
  }

 private:
  sim::Device& device_;
  std::map<std::string, Time> times_;  // accessed by the launching thread only
};

}  // namespace obby::bench
