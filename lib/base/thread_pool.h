// A fixed set of threads that run numbered tasks. The result of a task must depend on its number
// only, never on the thread or the order. Every result is then the same for any thread count.
//   ThreadPool pool(availableThreads());
//   pool.run(int(inputs.size()), [&](int i) { outputs[i] = worked(inputs[i]); });
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

// Returns the number of threads this process may use: SLURM_CPUS_PER_TASK if it is set, otherwise
// the CPUs of its affinity. At least 1.
int availableThreads();

class ThreadPool {
 public:
  // `threads` >= 1 includes the caller of run(). If the system grants fewer, the results are the
  // same.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return int(workers_.size()) + 1; }

  // Runs task(0) ... task(count - 1), each once, and returns when all are done. Once a task throws,
  // no other task begins. The first exception is rethrown when all threads are idle, and the pool
  // stays usable. Not reentrant.
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
  std::exception_ptr failure_;  // first exception of the current run
  uint64_t generation_ = 0;
  bool stop_ = false;
};

}  // namespace obby
