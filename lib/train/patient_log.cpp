#include "train/patient_log.h"

#include <fmt/format.h>

namespace obby::train {

void PatientLog::write() {
  held_ = file_.append(waiting_);
  if (!held_) return;
  waiting_.clear();
  rows_ = 0;
}

Status PatientLog::add(std::string_view row) {
  waiting_ += row;
  ++rows_;
  write();
  return patient_ && waiting_.size() <= kMostBytes ? Status() : held_;
}

Status PatientLog::finish() {
  write();
  if (held_) return {};
  Error error = held_.error();
  error.hint = fmt::format("rows missing at its end: {}", rows_);
  return error;
}

}  // namespace obby::train
