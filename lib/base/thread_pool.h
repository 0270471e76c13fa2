// A fixed set of threads that run numbered tasks. What a task computes must depend on its number
// only, never on the thread or the order: that is how every result is the same for any thread
// count.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace obby {

// Threads this process may use: its CPU affinity, or SLURM_CPUS_PER_TASK where that is set. At
// least 1.
int availableThreads();

class ThreadPool {
 public:
  // threads >= 1; the caller of run() is one of them. Fewer where the system gives no more: the
  // results are the same.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return int(workers_.size()) + 1; }

  // Runs task(0) ... task(count - 1), each once, and returns when all are done. After a task that
  // throws no other begins; what the first one threw is thrown here once all threads are idle, and
  // the pool can be used again. Not reentrant.
  void run(int count, const std::function<void(int)>& task);

 private:
  void work();
  void drain();

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable start_, done_;
  const std::function<void(int)>* task_ = nullptr;
  int count_ = 0;
  std::atomic<int> next_{0};
  int busy_ = 0;
  std::exception_ptr failure_;  // the first of a run
  uint64_t generation_ = 0;
  bool stop_ = false;
};

}  // namespace obby
