// Time limits for a stream that sends nothing, and for a reader of outputs that stalls.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "io/pipeline.h"

namespace obby::train {

// Stops the reader of a stream once `interrupted` is set, at end(), and when a record takes longer
// than `seconds` + `more`. The extra time lets callers with their own limit of `seconds` end first.
class WaitLimit {
 public:
  static constexpr double kMore = 3;       // seconds
  static constexpr double kNone = 1e30;    // never elapses
  static constexpr double kForFiles = 10;  // seconds; see lost()

  // `interrupted` must outlive it.
  WaitLimit(const std::atomic<bool>& interrupted, double seconds, double more = kMore);
  ~WaitLimit();
  WaitLimit(const WaitLimit&) = delete;
  WaitLimit& operator=(const WaitLimit&) = delete;

  // The flag for the reader's io::SourceOptions. Lives as long as this; it is never cleared.
  const std::atomic<bool>& stop() const { return stop_; }
  // Returns true if the time limit set it.
  bool isUp() const { return up_; }
  // The flag for outputs whose readers may stall. Set with `interrupted`, and `seconds` after the
  // last begin(), which clears it. Lives as long as this.
  const std::atomic<bool>& late() const { return late_; }
  // As late(), but kForFiles later: for outputs that took hours of training.
  const std::atomic<bool>& lost() const { return lost_; }

  // As source.next(), of a source that uses stop(). Once `interrupted` is set, returns no record
  // instead of an error. Before begin() each record has its own time limit. One thread at a time.
  Result<std::optional<io::Record>> next(io::RecordSource& source);
  // Starts the time limit of the work. From now on all records share one limit.
  void begin();
  // Ends the work and stops readers, which may still wait for later records.
  void end() { stop_ = true; }

 private:
  using Clock = std::chrono::steady_clock;
  void watch();
  void read(bool now);

  const std::atomic<bool>& interrupted_;
  const double limit_, seconds_;  // limit of the work, and of a wait for a record
  std::atomic<bool> stop_{false}, up_{false}, late_{false}, lost_{false};
  std::mutex lock_;
  std::condition_variable wake_;
  bool over_ = false, begun_ = false, reading_ = false;
  Clock::time_point since_ = Clock::now();
  std::thread watcher_;  // last, as it uses the other members
};

}  // namespace obby::train
