// The thread pool: every task once, for any number of threads and tasks, run after run.
#include "base/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
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

TEST(ThreadPool, WhatTasksWroteIsThereWhenRunReturns) {
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

TEST(ThreadPool, APoolThatWasNeverUsedEnds) {
  for (int i = 0; i < 50; ++i) ThreadPool pool(6);
}

}  // namespace
}  // namespace obby
