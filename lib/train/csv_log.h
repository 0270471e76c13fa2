// Metrics as a table for other programs: a row an iteration, commas between, names in the first
// line. Columns that depend on the clock come last: without them the logs of equal runs are equal.
#pragma once

#include <atomic>
#include <span>
#include <string>
#include <utility>

#include "train/metrics.h"
#include "train/patient_log.h"

namespace obby::train {

class CsvLog {
 public:
  // Iterations up to `kept` stay in the file if it has any, for learning that goes on from there;
  // 0: it begins anew. Errors: those of the file, and one that has something else in it. `stop`: as
  // of io::Appender::open.
  static Result<CsvLog> open(const std::string& path, uint64_t kept,
                             const std::atomic<bool>* stop = nullptr);

  // As PatientLog::add(); of a device or a pipe each error counts.
  Status add(uint64_t iteration, std::span<const Metric> metrics);
  PatientLog& file() { return file_; }

 private:
  explicit CsvLog(PatientLog file) : file_(std::move(file)) {}

  PatientLog file_;
};

}  // namespace obby::train
