// Metrics for TensorBoard: an events file, which is TFRecord framing around Event messages of
// Protocol Buffers. Only what scalars need of either is here, written by hand: TensorFlow's
// tensorflow/core/util/event.proto and framework/summary.proto name the fields.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "train/metrics.h"
#include "train/patient_log.h"

namespace obby::train {

class EventLog {
 public:
  // A new file in the folder, which is made where there is none. TensorBoard drops what earlier
  // files say of iterations after `kept`: learning goes on from there, or begins anew (0).
  static Result<EventLog> open(const std::string& folder, uint64_t kept);

  // As PatientLog::add().
  Status add(uint64_t iteration, std::span<const Metric> metrics);
  PatientLog& file() { return file_; }

 private:
  explicit EventLog(PatientLog file) : file_(std::move(file)) {}

  PatientLog file_;
};

// CRC-32C (Castagnoli) of the bytes.
uint32_t crc32c(std::string_view bytes);

}  // namespace obby::train
