// A log on a disk that may be full for a while: what cannot be written waits in memory until there
// is room, so that learning goes on and no row is missing behind it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "io/appender.h"

namespace obby::train {

class PatientLog {
 public:
  static constexpr size_t kMostBytes = size_t(16) << 20;  // that wait: some hundred thousand rows

  // `file`: what stands at its beginning is in it. Of a device or a pipe each error counts.
  explicit PatientLog(io::Appender file) : file_(std::move(file)), patient_(file_.isRegular()) {}

  // Writes the row, behind those that wait. Error: it is no regular file, or too much waits.
  Status add(std::string_view row);
  // Of the last row: why it waits; success: it does not.
  const Status& held() const { return held_; }
  // Writes what waits. Error: it cannot be written, and is missing.
  Status finish();

 private:
  void write();

  io::Appender file_;
  bool patient_;
  std::string waiting_;  // whole rows
  uint64_t rows_ = 0;    // of them
  Status held_;
};

}  // namespace obby::train
