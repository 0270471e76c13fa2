// Metrics for TensorBoard: an events file, which is TFRecord framing around Event messages of
// Protocol Buffers. Only what scalars need of either is here, written by hand: TensorFlow's
// tensorflow/core/util/event.proto and framework/summary.proto name the fields.
#pragma once

#include <span>
#include <string>

#include "io/appender.h"
#include "train/metrics.h"

namespace obby::train {

class EventLog {
 public:
  // A new file in the folder, which is made where there is none. TensorBoard drops what earlier
  // files say of iterations after `kept`: learning goes on from there, or begins anew (0).
  static Result<EventLog> open(const std::string& folder, uint64_t kept);

  Status add(uint64_t iteration, std::span<const Metric> metrics);

 private:
  explicit EventLog(io::Appender file) : file_(std::move(file)) {}

  io::Appender file_;
};

// CRC-32C (Castagnoli) of the bytes.
uint32_t crc32c(std::string_view bytes);

}  // namespace obby::train
