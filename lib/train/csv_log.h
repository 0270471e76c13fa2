// Metrics as a table for other programs: a row an iteration, commas between, names in the first
// line. Columns that depend on the clock come last: without them the logs of equal runs are equal.
#pragma once

#include <span>
#include <string>

#include "io/appender.h"
#include "train/metrics.h"

namespace obby::train {

class CsvLog {
 public:
  // Iterations up to `kept` stay in the file if it has any, for learning that goes on from there;
  // 0: it begins anew. Errors: those of the file, and one that has something else in it. `stop`: as
  // of io::Appender::open.
  static Result<CsvLog> open(const std::string& path, uint64_t kept,
                             const std::atomic<bool>* stop = nullptr);

  Status add(uint64_t iteration, std::span<const Metric> metrics);

 private:
  explicit CsvLog(io::Appender file) : file_(std::move(file)) {}

  io::Appender file_;
};

}  // namespace obby::train
