#include "sim/host_device.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace obby::sim {
namespace {
constexpr std::align_val_t kAlignment{256};  // as cudaMalloc aligns
constexpr uint32_t kRolloutsATask = 16;  // few, so that a thousand rollouts keep all threads busy
}  // namespace

Result<void*> HostDevice::allocate(size_t bytes) {
  void* memory = ::operator new(bytes, kAlignment, std::nothrow);
  if (memory == nullptr) return makeError("not enough memory");
  std::memset(memory, 0xa5, bytes);  // no caller may rely on zeros
  return memory;
}

void HostDevice::release(void* memory) { ::operator delete(memory, kAlignment); }

Status HostDevice::upload(void* to, const void* from, size_t bytes) {
  std::memcpy(to, from, bytes);
  return {};
}

Status HostDevice::download(void* to, const void* from, size_t bytes) const {
  std::memcpy(to, from, bytes);
  return {};
}

Status HostDevice::copy(void* to, const void* from, size_t bytes) {
  std::memcpy(to, from, bytes);
  return {};
}

Status HostDevice::fill(void* to, uint8_t value, size_t bytes) {
  std::memset(to, value, bytes);
  return {};
}

Status HostDevice::launch(const Kernel& kernel, const void* arguments, uint32_t count) {
  pool_.run(int((count + kRolloutsATask - 1) / kRolloutsATask), [&](int block) {
    const uint32_t first = uint32_t(block) * kRolloutsATask,
                   last = std::min(count, first + kRolloutsATask);
    for (uint32_t i = first; i < last; ++i) kernel.body(arguments, i);
  });
  return {};
}

Result<KernelFacts> HostDevice::facts(const Kernel&) const {
  return makeError("a kernel on the CPU has no register counts");
}

}  // namespace obby::sim
