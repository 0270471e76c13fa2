// A table in a device's memory.
#pragma once

#include <span>

#include "sim/device.h"

namespace obby::sim {

template <class T>
class DeviceTable {
 public:
  // Makes the table hold `count` items. Their contents are undefined.
  Status make(Device& device, size_t count) {
    device_ = &device;
    count_ = count;
    return reserve(device, memory_, data_, count);
  }
  // Makes the table hold `count` items whose bytes are all 0.
  Status makeZero(Device& device, size_t count) {
    OBBY_RETURN_IF_ERROR(make(device, count));
    return clear();
  }
  Status clear() { return device_->fill(data_, 0, count_ * sizeof(T)); }
  // Copies items to the start of the table. `from` must not be longer than the table.
  Status put(std::span<const T> from) {
    return device_->upload(data_, from.data(), from.size_bytes());
  }
  Result<std::vector<T>> get() const { return downloadTable(*device_, data_, count_); }

  T* data() const { return data_; }  // an address of the device
  size_t size() const { return count_; }

 private:
  Device* device_ = nullptr;
  Memory memory_;
  T* data_ = nullptr;
  size_t count_ = 0;
};

}  // namespace obby::sim
