// The time limit of a run, for input streams that send nothing and for outputs whose readers stall.
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
// than `seconds` + `grace`. The grace period lets callers with their own limit of `seconds` end
// first.
class Timeout {
 public:
  static constexpr double kGrace = 3;    // seconds
  static constexpr double kNone = 1e30;  // never elapses

  // `interrupted` must outlive this object.
  Timeout(const std::atomic<bool>& interrupted, double seconds, double grace = kGrace);
  ~Timeout();
  Timeout(const Timeout&) = delete;
  Timeout& operator=(const Timeout&) = delete;

  // The flag for the reader's io::SourceOptions. It is never cleared.
  const std::atomic<bool>& stop() const { return stop_; }
  // Returns true if the time limit set stop().
  bool expired() const { return expired_; }
  // The flag for outputs whose readers may stall. It is set with `interrupted`, and `seconds` after
  // begin().
  const std::atomic<bool>& late() const { return late_; }

  // Returns source.next(), of a source that uses stop(). Once `interrupted` is set, returns no
  // record instead of an error. Before begin() each record has its own time limit. Only one thread
  // at a time may call this.
  Result<std::optional<io::Record>> next(io::RecordSource& source);
  // Starts the time limit of the work. From now on all records share one limit.
  void begin();
  // Ends the work and stops readers, which may still wait for later records.
  void end() { stop_ = true; }

 private:
  using Clock = std::chrono::steady_clock;
  void watch();
  void setReading(bool now);

  const std::atomic<bool>& interrupted_;
  // Limits of the work and of a wait for a record, seconds.
  const double workSeconds_, recordSeconds_;
  std::atomic<bool> stop_{false}, expired_{false}, late_{false};
  std::mutex lock_;
  std::condition_variable wake_;
  bool over_ = false, begun_ = false, reading_ = false;
  Clock::time_point since_ = Clock::now();
  std::thread watcher_;  // last, as it uses the other members
};

}  // namespace obby::train
