// Metrics for TensorBoard: an events file, which is TFRecord framing around Protocol Buffers
// messages of type Event. It implements only what scalars need. TensorFlow's
// tensorflow/core/util/event.proto and framework/summary.proto define the fields.
//
// The log survives a full disk: events that cannot be written wait in memory, so that training goes
// on and none is lost.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "io/appender.h"
#include "train/run/metrics.h"

namespace obby::train {

class EventLog {
 public:
  // Creates a new file in the folder, and the folder if needed. TensorBoard drops entries of
  // earlier files after iteration `kept`, the iteration from which training resumes (0: a new run).
  static Result<EventLog> open(const std::string& folder, uint64_t kept);

  // Writes the metrics after the events that wait.
  void add(uint64_t iteration, std::span<const Metric> metrics);
  // Returns why the last event waits; success if it was written.
  const Status& held() const { return held_; }
  // Writes the waiting events. On an error they are lost.
  Status finish();

 private:
  explicit EventLog(io::Appender file) : file_(std::move(file)) {}

  void write();

  io::Appender file_;
  std::string waiting_;  // whole events
  uint64_t events_ = 0;  // number of waiting events
  Status held_;
};

// Returns the CRC-32C (Castagnoli) of the bytes.
uint32_t crc32c(std::string_view bytes);

}  // namespace obby::train
