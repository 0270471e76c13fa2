// A fixed set of threads that run numbered tasks. What a task computes must depend on its number
// only, never on the thread or the order: that is how every result is the same for any thread
// count.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
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
  explicit ThreadPool(int threads);  // threads >= 1; the caller of run() is one of them
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return int(workers_.size()) + 1; }

  // Runs task(0) ... task(count - 1), each once, and returns when all are done. Not reentrant.
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
  uint64_t generation_ = 0;
  bool stop_ = false;
};

}  // namespace obby
