// Training on a batch allocates memory once, for any number of minibatches and epochs.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

#include "train/some_batch.h"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// Counts the allocations of this program, including those by operator new.
namespace {
std::atomic<size_t> asked{0};
}
extern "C" void* __libc_malloc(size_t bytes);
extern "C" void* malloc(size_t bytes) {
  asked.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(bytes);
}

namespace obby::train {
namespace {

constexpr uint32_t kWorlds = 1024;

// Returns the number of allocations in the second update with a batch.
size_t askedFor(uint32_t epochs, uint32_t minibatch) {
  ThreadPool pool(2);
  OneRank alone;
  PpoSettings settings;
  settings.epochs = epochs;
  settings.minibatch = minibatch;
  Ppo ppo(settings, 1, pool, alone);
  Batch batch = someBatch(0, kWorlds);
  ppo.learn(batch, 1);
  const size_t before = asked;
  ppo.learn(batch, 1);
  return asked - before;
}

TEST(Allocation, MinibatchesAndEpochsAllocateNothing) {
  const size_t min = askedFor(1, kTicks * kWorlds);
  EXPECT_GT(min, 0u) << "otherwise nothing is counted";
  EXPECT_LT(min, 100u);
  EXPECT_EQ(askedFor(4, kTicks * kWorlds), min);
  EXPECT_EQ(askedFor(4, 512), min);
}

}  // namespace
}  // namespace obby::train

#endif
