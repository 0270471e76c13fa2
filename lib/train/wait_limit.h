// How long learning waits for a stream that sends nothing, and for who takes nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "io/pipeline.h"

namespace obby::train {

// Tells who reads a stream to stop: once `interrupted` is set, at end(), and while it waits for a
// record that does not come within the time. That is `seconds` and a little `more`, so that who has
// a clock of its own is through before wherever records come.
class WaitLimit {
 public:
  static constexpr double kMore = 3;       // seconds
  static constexpr double kNone = 1e30;    // seconds that never pass
  static constexpr double kForFiles = 10;  // seconds, see lost()

  // `interrupted` must outlive it.
  WaitLimit(const std::atomic<bool>& interrupted, double seconds, double more = kMore);
  ~WaitLimit();
  WaitLimit(const WaitLimit&) = delete;
  WaitLimit& operator=(const WaitLimit&) = delete;

  // For the reader's io::SourceOptions. Lives as long as this; once set it stays.
  const std::atomic<bool>& stop() const { return stop_; }
  // Was it set for the time?
  bool isUp() const { return up_; }
  // For outputs, whose readers may stall: set once `interrupted` is, and `seconds` after the last
  // begin(), which takes it back. Lives as long as this.
  const std::atomic<bool>& late() const { return late_; }
  // The same for outputs that hours of learning went into: after the time kForFiles later.
  const std::atomic<bool>& lost() const { return lost_; }

  // As source.next(), of a source that has stop(); but once `interrupted` is set, none in place of
  // an error. Before begin() each record has the time for itself. One thread at a time.
  Result<std::optional<io::Record>> next(io::RecordSource& source);
  // The work that has a limit begins: the time is from now on that of all records together.
  void begin();
  // The work is done: who still reads, as for what would come next, is told to stop.
  void end() { stop_ = true; }

 private:
  using Clock = std::chrono::steady_clock;
  void watch();
  void read(bool now);

  const std::atomic<bool>& interrupted_;
  const double limit_, seconds_;  // of the work; of what is waited for
  std::atomic<bool> stop_{false}, up_{false}, late_{false}, lost_{false};
  std::mutex lock_;
  std::condition_variable wake_;
  bool over_ = false, begun_ = false, reading_ = false;
  Clock::time_point since_ = Clock::now();
  std::thread watcher_;  // last: it uses all of it
};

}  // namespace obby::train
