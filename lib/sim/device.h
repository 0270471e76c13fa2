// Memory and launches of a device that runs kernels: a GPU, or the CPU in its place for tests.
// Errors of the driver are returned as Results.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/flatten.h"
#include "base/result.h"
#include "sim/kernel.h"

namespace obby::sim {

// Facts about a kernel from the compiler and the driver.
struct KernelFacts {
  int registers = 0;    // per thread
  int localBytes = 0;   // per thread: stack and spills
  int threads = 0;      // per block
  int blocksPerSm = 0;  // resident at once
  int smCount = 0;
};

class Device {
 public:
  virtual ~Device() = default;

  virtual std::string name() const = 0;

  // The memory is aligned to at least 128 bytes. Any thread may call this.
  virtual Result<void*> allocate(size_t bytes) = 0;
  virtual void release(void* memory) = 0;
  // Copies host memory to the device, after the kernels enqueued so far. The host memory may change
  // as soon as this returns.
  virtual Status upload(void* to, const void* from, size_t bytes) = 0;
  // Uploads while kernels run, from any thread, and returns when it is done. No kernel enqueued
  // earlier may use that memory.
  virtual Status uploadAside(void* to, const void* from, size_t bytes) = 0;
  // Copies memory of the device to the host, after the kernels enqueued so far, and waits.
  virtual Status download(void* to, const void* from, size_t bytes) const = 0;
  // Both work on device memory.
  virtual Status copy(void* to, const void* from, size_t bytes) = 0;
  virtual Status fill(void* to, uint8_t value, size_t bytes) = 0;

  // Runs the kernel for 0 ... count - 1 and waits until it is done.
  virtual Status launch(const Kernel& kernel, const void* arguments, uint32_t count) = 0;
  // Launches a kernel, but may return before it is done. Later calls run after it, and may return
  // its errors.
  virtual Status enqueue(const Kernel& kernel, const void* arguments, uint32_t count) {
    return launch(kernel, arguments, count);
  }
  // Launches two kernels that do not depend on each other, at the same time if the device can.
  virtual Status enqueueTogether(const Kernel& a, const Kernel& b, const void* arguments,
                                 uint32_t count) {
    OBBY_RETURN_IF_ERROR(enqueue(a, arguments, count));
    return enqueue(b, arguments, count);
  }
  virtual Result<KernelFacts> facts(const Kernel& kernel) const = 0;
};

// Calls Device::enqueue with typed arguments.
template <class Arguments>
Status enqueue(Device& device, const Kernel& kernel, const Arguments& arguments, size_t count) {
  return device.enqueue(kernel, &arguments, uint32_t(count));
}

// Memory of a device, released with this object. Must not outlive the device.
class Memory {
 public:
  Memory() = default;
  Memory(Memory&& other) noexcept { *this = std::move(other); }
  Memory& operator=(Memory&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(address_, other.address_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~Memory() {
    if (address_ != nullptr) device_->release(address_);
  }

  static Result<Memory> of(Device& device, size_t bytes) {
    Memory memory;
    if (bytes == 0) return memory;
    OBBY_ASSIGN(memory.address_, device.allocate(bytes));
    memory.device_ = &device;
    memory.bytes_ = bytes;
    return memory;
  }

  void* address() const { return address_; }
  template <class T>
  T* as() const {
    return static_cast<T*>(address_);
  }
  size_t bytes() const { return bytes_; }

 private:
  Device* device_ = nullptr;
  void* address_ = nullptr;
  size_t bytes_ = 0;
};

// Makes `memory` hold at least `count` items. Its contents may be lost.
template <class T>
Status reserve(Device& device, Memory& memory, T*& table, size_t count) {
  if (memory.bytes() < count * sizeof(T)) {
    memory = {};  // freed first, so that the old and new memory never coexist
    OBBY_ASSIGN(memory, Memory::of(device, count * sizeof(T)));
  }
  table = memory.as<T>();
  return {};
}

// Returns a copy of a table of `count` items in the device's memory.
template <class T>
Result<std::vector<T>> downloadTable(const Device& device, const T* table, size_t count) {
  std::vector<T> copy(count);
  if (count != 0) OBBY_RETURN_IF_ERROR(device.download(copy.data(), table, count * sizeof(T)));
  return copy;
}

// Uploads a table. `memory` grows if it is too small.
template <class T>
Status uploadTable(Device& device, Memory& memory, std::span<const T> table) {
  if (memory.bytes() < table.size_bytes()) {
    OBBY_ASSIGN(memory, Memory::of(device, table.size_bytes()));
  }
  return table.empty() ? Status()
                       : device.upload(memory.address(), table.data(), table.size_bytes());
}

// Uploads all tables of `root` in one piece, and points `root` to them.
template <class Root>
Result<Memory> uploadTables(Device& device, Root& root) {
  Root sized = root;  // the address is known only after the size
  OBBY_ASSIGN(Memory memory, Memory::of(device, flatten(sized, 0).size()));
  const auto bytes = flatten(root, reinterpret_cast<uintptr_t>(memory.address()));
  OBBY_RETURN_IF_ERROR(uploadTable<std::byte>(device, memory, bytes));
  return memory;
}

}  // namespace obby::sim
