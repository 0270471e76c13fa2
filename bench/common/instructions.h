// Counts retired CPU instructions, a measure that does not vary with other load.
#pragma once

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <optional>

namespace obby::bench {

// Counts this thread's instructions outside the kernel. Virtual machines often have no counter.
class InstructionCounter {
 public:
  InstructionCounter() {
    perf_event_attr attributes{};
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
    attributes.exclude_kernel = attributes.exclude_hv = 1;
    file_ = int(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
  }
  ~InstructionCounter() {
    if (file_ >= 0) close(file_);
  }
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;

  // Returns the count since construction, or nothing without a counter.
  std::optional<uint64_t> count() const {
    uint64_t value = 0;
    if (file_ < 0 || read(file_, &value, sizeof value) != sizeof value) return std::nullopt;
    return value;
  }

 private:
  int file_;
};

}  // namespace obby::bench
