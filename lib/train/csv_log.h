// Metrics as CSV for other programs: names in the first line, then one row per iteration. Columns
// that depend on the clock come last; all others are equal for equal runs.
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
  // Opens the log and keeps its rows of iterations up to `kept`, for a resumed run; 0 starts it
  // anew. Errors: those of the file, and a file with other content. `stop`: see io::Appender::open.
  static Result<CsvLog> open(const std::string& path, uint64_t kept,
                             const std::atomic<bool>* stop = nullptr);

  // As PatientLog::add(). On a device or a pipe each error is final.
  Status add(uint64_t iteration, std::span<const Metric> metrics);
  PatientLog& file() { return file_; }

 private:
  explicit CsvLog(PatientLog file) : file_(std::move(file)) {}

  PatientLog file_;
};

}  // namespace obby::train
