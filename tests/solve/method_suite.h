// Tests that every search method must pass. A method solves easy queries, spends its budget on
// others, uses an earlier answer, and depends only on its inputs. Private to tests: instantiate it
// for a table.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "policy/shipped_policy.h"
#include "sim/host_device.h"
#include "solve/changed_stones.h"
#include "solve/scenes.h"
#include "solve/untimed.h"

namespace obby::solve {

class MethodTest : public testing::TestWithParam<Method> {
 protected:
  static FilterOptions options(uint64_t maxSteps, int threads = 2) {
    FilterOptions o;
    o.threads = threads;
    o.solver.method = &GetParam();
    o.solver.budget.maxSteps = maxSteps;
    o.solver.budget.attempts = 4;
    o.solver.progressRecords = false;
    return o;
  }
  static Filtered ask(const std::string& more, FilterOptions o) {
    const LinesFile file(stonesText(more));
    Filtered f = runFilter(file.path(), std::move(o));
    EXPECT_TRUE(f.status) << f.status.error().text();
    return f;
  }
};

TEST_P(MethodTest, SolvesTheSteppingStones) {
  EXPECT_EQ(ask("", options(3'000'000)).counts.solved, 1u);
}

TEST_P(MethodTest, SpendsItsStepsIfThereIsNoSolution) {
  const char* wall = R"(,"avoid":[{"position":[0,0,-10],"size":[200,200,1]}])";
  const Filtered f = ask(wall, options(50'000));
  EXPECT_EQ(f.counts.unknown, 1u) << f.output;
}

TEST_P(MethodTest, SameBytesForAnyNumberOfThreadsAndAKernel) {
  const char* more =
      R"(,"waypoints":[{"region":{"position":[3,2,-16]},"maxJumps":1}],"maxJumps":1)";
  const std::string expected = withoutTiming(ask(more, options(60'000, 1)).output);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(withoutTiming(ask(more, options(60'000, threads)).output), expected) << threads;
  }
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  FilterOptions o = options(60'000);
  o.device = &device;
  EXPECT_EQ(withoutTiming(ask(more, o).output), expected) << "kernel";
}

TEST_P(MethodTest, UsesAnEarlierAnswer) {
  const LinesFile stones(stonesText()), changed(fourStones());
  FilterOptions o = options(20'000);
  o.solver.method = findMethod("auto");
  const EarlierAnswers before = answersIn(runFilter(stones.path(), o).output);
  o.solver.method = &GetParam();
  o.solver.policy = &policy::shippedPolicy().network;
  o.earlier = before;
  EXPECT_EQ(runFilter(stones.path(), o).counts.solved, 1u);
  EXPECT_THAT(runFilter(changed.path(), std::move(o)).output,
              testing::HasSubstr("\"type\":\"result\""));
}

inline std::string nameOf(const testing::TestParamInfo<Method>& row) {
  std::string name = row.param.name;
  std::erase(name, '-');  // not allowed in test names
  return name;
}

}  // namespace obby::solve
