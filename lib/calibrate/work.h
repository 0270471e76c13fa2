// The execution context of a fit: threads, the stop flag and progress reports.
#pragma once

#include <atomic>
#include <functional>
#include <limits>

#include "base/thread_pool.h"

namespace obby::calibrate {

// Progress of a fit.
struct FitProgress {
  const char* task = "";                             // current phase
  double share = 0;                                  // share of the whole; never decreases
  double loss = std::numeric_limits<double>::max();  // the lowest so far
  uint64_t evaluations = 0;                          // number so far
};

// An interval of the whole progress, in shares.
struct Stretch {
  double from = 0, to = 1;

  Stretch of(double a, double b) const { return {from + (to - from) * a, from + (to - from) * b}; }
};

// Progress counters. Any thread may count; all other members belong to the fitting thread.
class Account {
 public:
  using Tell = std::function<void(const FitProgress&)>;
  explicit Account(Tell tell) : tell_(std::move(tell)) {}

  void enter(const char* task, Stretch stretch);
  void step(size_t done, size_t all);  // within the current stretch
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

// A view of the context that is cheap to copy.
class Work {
 public:
  Work(ThreadPool& pool, const std::atomic<bool>& stop, Account& account)
      : pool_(&pool), stop_(&stop), account_(&account) {}

  // Returns a copy for use inside a task, which runs on the task's thread.
  Work inTask() const { return {nullptr, stop_, account_}; }
  // Returns a copy without the stop flag, for work that must complete.
  Work toItsEnd() const { return {pool_, nullptr, account_}; }

  // Returns true from the moment at which a stop is requested.
  bool stopped() const { return stop_ != nullptr && *stop_; }
  // Runs task(0) ... task(count - 1), each once. After a stop no further task starts, so outputs
  // may be missing. Reports progress after each task of the calling thread.
  void run(int count, const std::function<void(int)>& task) const;
  Account& account() const { return *account_; }

 private:
  Work(ThreadPool* pool, const std::atomic<bool>* stop, Account* account)
      : pool_(pool), stop_(stop), account_(account) {}

  ThreadPool* pool_;               // null: inside a task
  const std::atomic<bool>* stop_;  // null: never stops
  Account* account_;
};

}  // namespace obby::calibrate
