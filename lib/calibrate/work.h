// What a fit works with: its threads, whether it is to stop, and whom it tells how far it has come.
#pragma once

#include <atomic>
#include <functional>
#include <limits>

#include "base/thread_pool.h"

namespace obby::calibrate {

// How far a fit has come.
struct FitProgress {
  const char* task = "";  // what it is at
  double share = 0;       // of all that may be to do; never less than before
  double loss = std::numeric_limits<double>::max();  // the least so far
  uint64_t evaluations = 0;                          // of the recordings, so far
};

// A stretch of all that is to do, in shares of it.
struct Stretch {
  double from = 0, to = 1;

  Stretch of(double a, double b) const { return {from + (to - from) * a, from + (to - from) * b}; }
};

// What has been done. Counted from any thread; all else is for the one that fits.
class Account {
 public:
  using Tell = std::function<void(const FitProgress&)>;
  explicit Account(Tell tell) : tell_(std::move(tell)) {}

  void enter(const char* task, Stretch stretch);
  void step(size_t done, size_t all);  // of the stretch that was entered
  void found(double loss);
  void tell() const;
  void count(uint64_t evaluations) { evaluations_ += evaluations; }
  uint64_t evaluations() const { return evaluations_; }

 private:
  void reach(double share);

  const Tell tell_;
  Stretch stretch_;
  FitProgress progress_;
  std::atomic<uint64_t> evaluations_{0};
};

// A view of these; cheap to copy.
class Work {
 public:
  Work(ThreadPool& pool, const std::atomic<bool>& stop, Account& account)
      : pool_(&pool), stop_(&stop), account_(&account) {}

  // The same inside a task: by the thread that runs the task.
  Work inTask() const { return {nullptr, stop_, account_}; }
  // The same, of what is needed even after a stop.
  Work toItsEnd() const { return {pool_, nullptr, account_}; }

  // From outside. Once true it stays so.
  bool stopped() const { return stop_ != nullptr && *stop_; }
  // task(0) ... task(count - 1), each once; after a stop none is begun any more, so that what they
  // were to write may be missing. Tells after each that the calling thread has done.
  void run(int count, const std::function<void(int)>& task) const;
  Account& account() const { return *account_; }

 private:
  Work(ThreadPool* pool, const std::atomic<bool>* stop, Account* account)
      : pool_(pool), stop_(stop), account_(account) {}

  ThreadPool* pool_;               // null: in a task
  const std::atomic<bool>* stop_;  // null: to its end
  Account* account_;
};

}  // namespace obby::calibrate
