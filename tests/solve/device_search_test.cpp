// A search with rollouts as a kernel gives the same bytes as one on threads, even if the device
// fails midway.
#include <gtest/gtest.h>

#include "scenes.h"
#include "solve/search/methods/go_explore.h"
#include "support/failing_device.h"
#include "untimed.h"

namespace obby::solve {
namespace {

FilterOptions onDevice(sim::Device* device) {
  FilterOptions o;
  o.threads = 2;
  o.device = device;
  o.solver.budget.maxSteps = 60'000;
  o.solver.progressRecords = false;
  return o;
}

std::string answers(const char* level, FilterOptions options) {
  const std::string path = std::string(OBBY_SOURCE_DIR "/levels/") + level + ".jsonl";
  const Filtered f = runFilter(path, std::move(options));
  EXPECT_TRUE(f.status);
  return withoutTiming(f.output);
}

TEST(DeviceSearch, AnswersEqualThoseOfThreads) {
  for (const char* level : {"kill-checkerboard", "vanishing-run", "sliding-planks", "truss-tower",
                            "several-routes", "spinner-trio"}) {
    ThreadPool pool(2);
    sim::HostDevice device(pool);
    EXPECT_EQ(answers(level, onDevice(&device)), answers(level, onDevice(nullptr))) << level;
  }
}

TEST(DeviceSearch, AFailingDeviceIsGivenUpAndTheAnswersAreTheSame) {
  for (const int launches : {0, 1, 3}) {
    ThreadPool pool(2);
    support::FailingDevice device(pool, launches);
    FilterOptions options = onDevice(&device);
    std::vector<std::string> failures;
    options.deviceFailed = [&](const Error& e) { failures.push_back(e.text()); };
    EXPECT_EQ(answers("sliding-planks", options), answers("sliding-planks", onDevice(nullptr)));
    ASSERT_FALSE(failures.empty());
    EXPECT_EQ(failures.front(), "CUDA: rollout: unspecified launch failure");
  }
}

TEST(DeviceSearch, TheArchiveIsTheSameCellByCell) {
  const level::Level level = support::movingArena(40, 8, 3).compile();
  PlainQuery asked(level);
  asked.query.goal = boxAt({0, 500, 0}, {2, 2, 2});
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  GoExplore threads(asked.problem(), 4, {}, pool);
  GoExplore kernel(asked.problem(), 4, {}, {pool, &device});
  for (int round = 0; round < 25; ++round) {
    threads.round();
    kernel.round();
  }
  ASSERT_TRUE(kernel.deviceStatus());
  ASSERT_EQ(threads.archive().cellCount(), kernel.archive().cellCount());
  EXPECT_EQ(threads.archive().seen(), kernel.archive().seen());
  for (uint32_t c = 0; c < threads.archive().cellCount(); ++c) {
    ASSERT_EQ(stateHash(threads.archive().world(c)), stateHash(kernel.archive().world(c))) << c;
  }
}

}  // namespace
}  // namespace obby::solve
