// The thread pool runs each task once, for any number of threads and tasks, and can run again. Also
// tests tasks that throw, and a system that refuses threads.
#include "base/thread_pool.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <set>
#include <vector>

namespace obby {
namespace {

TEST(ThreadPool, RunsEveryTaskOnceForAnyThreadAndTaskCount) {
  for (const int threads : {1, 2, 3, 8, 17}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.size(), threads);
    for (const int count : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> runs(size_t(count) + 1);
      pool.run(count, [&](int i) { ++runs[size_t(i)]; });
      for (int i = 0; i < count; ++i) EXPECT_EQ(runs[size_t(i)], 1) << threads << " " << i;
      EXPECT_EQ(runs[size_t(count)], 0);
    }
  }
}

TEST(ThreadPool, CanBeUsedManyTimesInARow) {
  ThreadPool pool(4);
  std::atomic<int64_t> sum = 0;
  for (int round = 0; round < 2000; ++round) pool.run(5, [&](int i) { sum += i; });
  EXPECT_EQ(sum, 2000 * (0 + 1 + 2 + 3 + 4));
}

TEST(ThreadPool, WritesOfTasksAreVisibleWhenRunReturns) {
  ThreadPool pool(3);
  std::vector<int> values(512);
  for (int round = 1; round <= 50; ++round) {
    pool.run(int(values.size()), [&](int i) { values[size_t(i)] = round * i; });
    for (size_t i = 0; i < values.size(); ++i) ASSERT_EQ(values[i], round * int(i));
  }
}

TEST(ThreadPool, UsesNoMoreThreadsThanAskedFor) {
  for (const int threads : {1, 3}) {
    ThreadPool pool(threads);
    std::mutex mutex;
    std::set<std::thread::id> seen;
    pool.run(300, [&](int) {
      std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    EXPECT_LE(seen.size(), size_t(threads));
  }
}

TEST(ThreadPool, OneThreadRunsTasksInOrderOnTheCaller) {
  ThreadPool pool(1);
  std::vector<int> order;
  pool.run(4, [&](int i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3}));
}

TEST(ThreadPool, AnUnusedPoolShutsDown) {
  for (int i = 0; i < 50; ++i) ThreadPool pool(6);
}

int sumOfTasks(ThreadPool& pool, int count) {
  std::atomic<int> sum = 0;
  pool.run(count, [&](int i) { sum += i; });
  return sum;
}

TEST(ThreadPool, RunRethrowsATasksExceptionAndThePoolContinues) {
  for (const int threads : {1, 2, 8}) {
    ThreadPool pool(threads);
    for (int round = 0; round < 50; ++round) {
      EXPECT_THROW(pool.run(100, [](int) { throw std::bad_alloc(); }), std::bad_alloc);
      EXPECT_EQ(sumOfTasks(pool, 100), 4950);
    }
  }
}

TEST(ThreadPool, AWorkersExceptionReachesTheCaller) {
  ThreadPool pool(3);
  const auto caller = std::this_thread::get_id();
  std::atomic<bool> thrown = false;
  const auto task = [&](int) {
    if (std::this_thread::get_id() != caller) {
      thrown = true;
      throw std::bad_alloc();
    }
    while (!thrown) std::this_thread::yield();
  };
  EXPECT_THROW(pool.run(1000, task), std::bad_alloc);
  EXPECT_EQ(sumOfTasks(pool, 10), 45);
}

TEST(ThreadPool, RunThrowsOnlyAfterAllTasksHaveEnded) {
  ThreadPool pool(4);
  const auto caller = std::this_thread::get_id();
  std::atomic<int> begun = 0, inside = 0;
  const auto task = [&](int) {
    ++begun;
    if (std::this_thread::get_id() == caller) {
      while (inside == 0) std::this_thread::yield();
      throw std::bad_alloc();
    }
    ++inside;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    --inside;
  };
  EXPECT_THROW(pool.run(1000, task), std::bad_alloc);
  EXPECT_EQ(inside, 0);
  EXPECT_LT(begun, 1000);
}

// Makes every new thread fail: the default stack size is larger than any machine can map.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    pthread_getattr_default_np(&usual_);
    pthread_attr_t vast;
    pthread_attr_init(&vast);
    pthread_attr_setstacksize(&vast, size_t(1) << 48);
    pthread_setattr_default_np(&vast);
    pthread_attr_destroy(&vast);
  }
  ~NoMoreThreads() {
    pthread_setattr_default_np(&usual_);
    pthread_attr_destroy(&usual_);
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;

 private:
  pthread_attr_t usual_;
};

TEST(ThreadPool, UsesTheThreadsThatItGets) {
  const NoMoreThreads limit;
  ThreadPool pool(4);
  EXPECT_EQ(pool.size(), 1);
  EXPECT_EQ(sumOfTasks(pool, 100), 4950);
}

}  // namespace
}  // namespace obby
