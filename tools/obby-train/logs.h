// Where people look how learning goes: --log, --tensorboard, --curve.
#pragma once

#include <atomic>
#include <optional>

#include "cli/context.h"
#include "train/csv_log.h"
#include "train/event_log.h"
#include "train/history.h"

namespace obby::tools {

class Logs {
 public:
  // `kept`: iterations before, of which `history` knows. Errors: those of the files; of a named
  // pipe from which nobody takes anything once `late` is set, which must outlive this.
  static Result<Logs> open(const cli::Arguments& arguments, const std::atomic<bool>& late,
                           uint64_t kept, train::History history);

  // To be called after each iteration; `last`: no more will come. Rows of a file that cannot be
  // written wait (train::PatientLog).
  Status add(const train::Iteration& iteration, double seconds, double rate, bool last);
  // Why rows wait; success: none does.
  Status held();
  // Writes those that wait. Error: rows are missing.
  Status finish();
  // Writes the curve.
  Status save() const;

  const train::History& history() const { return history_; }

 private:
  std::optional<train::CsvLog> csv_;
  std::optional<train::EventLog> events_;
  std::string curvePath_;
  const std::atomic<bool>* late_ = nullptr;
  uint64_t every_ = 1;
  train::History history_;
};

}  // namespace obby::tools
