// A log that survives a full disk. Rows that cannot be written wait in memory, so that training
// goes on and no row is lost.
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
  static constexpr size_t kMostBytes = size_t(16) << 20;  // max bytes of waiting rows

  // `file` holds the log's earlier rows. On a device or a pipe each error is final.
  explicit PatientLog(io::Appender file) : file_(std::move(file)), patient_(file_.isRegular()) {}

  // Writes the row after those that wait. Errors: the file is not regular, or too much waits.
  Status add(std::string_view row);
  // Returns why the last row waits; success if it was written.
  const Status& held() const { return held_; }
  // Writes the waiting rows. On an error they are lost.
  Status finish();

 private:
  void write();

  io::Appender file_;
  bool patient_;
  std::string waiting_;  // whole rows
  uint64_t rows_ = 0;    // number of them
  Status held_;
};

}  // namespace obby::train
