// Metrics for TensorBoard: an events file, which is TFRecord framing around Protocol Buffers
// messages of type Event. It implements only what scalars need. TensorFlow's
// tensorflow/core/util/event.proto and framework/summary.proto define the fields.
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
  // Creates a new file in the folder, and the folder if needed. TensorBoard drops entries of
  // earlier files after iteration `kept`, the iteration from which training resumes (0: a new run).
  static Result<EventLog> open(const std::string& folder, uint64_t kept);

  // As PatientLog::add().
  Status add(uint64_t iteration, std::span<const Metric> metrics);
  PatientLog& file() { return file_; }

 private:
  explicit EventLog(PatientLog file) : file_(std::move(file)) {}

  PatientLog file_;
};

// Returns the CRC-32C (Castagnoli) of the bytes.
uint32_t crc32c(std::string_view bytes);

}  // namespace obby::train
