// The runs that a call of bench_solve plans, and its estimate of a query's effort.
#include "suite/plan.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "solve/methods.h"
#include "suite/effort.h"

namespace obby::bench {
namespace {

constexpr const char* kLevel =
    R"({"type":"level","name":"flat","parts":[{"position":[0,-0.5,0],"size":[200,1,200]},)"
    R"({"position":[20,1,0],"size":[1,1,1],"kill":{}},{"position":[20,1,90],"size":[1,1,1],"kill":{}}],)"
    R"("spawns":[{"position":[0,0,0]}]})"
    "\n";
constexpr const char* kQueries =
    R"({"type":"query","id":"walk","goal":{"position":[44,3,0],"size":[2,6,2]}})"
    "\n"
    R"({"type":"query","id":"by way of","goal":{"position":[44,3,0],"size":[2,6,2]},"maxJumps":1,)"
    R"("waypoints":[{"region":{"position":[10,3,0],"size":[2,6,2]}}],)"
    R"("avoid":[{"position":[0,3,60],"size":[2,6,2]}]})"
    "\n"
    R"({"type":"query","id":"up","goal":{"position":[0,503,0],"size":[2,6,2]}})"
    "\n";

// A folder that contains a suite of one level.
class SuiteFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "deeper");
    std::ofstream(folder_ / "deeper" / "flat.jsonl") << kLevel << kQueries;
    std::ofstream(folder_ / "expected.tsv") << "# a comment\n"
                                            << "deeper/flat.jsonl\twalk\tsolved\ttest\tflat\n"
                                            << "deeper/flat.jsonl\tby way of\tsolved\ttest\tflat\n"
                                            << "deeper/flat.jsonl\tup\tunreachable\ttest\thigh\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Plan plan() const {
    Plan p;
    p.methods = {solve::findMethod("auto"), solve::findMethod("ge")};
    p.suite = *loadSuite(folder_.string(), {});
    p.seeds = 2;
    return p;
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(SuiteFolder, EffortSumsDistanceHazardsTargetsAndLimits) {
  const std::vector<SuiteQuery> suite = plan().suite;
  // The near edge of the goal is 43 studs away, and a jump covers 8.6. One of the two kill parts is
  // near the straight line.
  EXPECT_NEAR(suite[0].effort, 5 + 0.5, 1e-4);
  // This query adds a waypoint, a limit and a region to avoid.
  EXPECT_NEAR(suite[1].effort, 5 + 0.5 + 2 + 2 + 1, 1e-4);
  // A stud upwards counts three times. The straight line, a column above the start, is far from
  // every kill part.
  EXPECT_NEAR(suite[2].effort, 500 * 3 / 8.6, 1e-3);
}

TEST_F(SuiteFolder, QueriesOfOneLevelDifferInContent) {
  const std::vector<SuiteQuery> suite = plan().suite;
  EXPECT_NE(suite[0].content, suite[1].content);
  EXPECT_EQ(suite[0].content, plan().suite[0].content);
}

// The content does not depend on where the suite is stored.
TEST_F(SuiteFolder, ContentIsEverythingThatCanChangeATrajectory) {
  const uint64_t content = plan().suite[0].content;
  const auto with = [&](const std::string& more) {
    std::string level = kLevel;
    level.insert(level.find(R"("parts")"), more);
    std::ofstream(folder_ / "deeper" / "flat.jsonl") << level << kQueries;
    return plan().suite[0].content;
  };
  EXPECT_EQ(with(R"("source":{"file":"/elsewhere/flat.rbxlx"},)"), content);
  EXPECT_NE(with(R"("physics":{"gravity":100},)"), content);
}

TEST_F(SuiteFolder, UnsolvableQueriesRunOnceByTheFirstMethodOnly) {
  const Plan p = plan();
  EXPECT_EQ(p.trials().size(), 2u * 2 * 2 + 1);
  EXPECT_TRUE(p.asks(0, 2, 1));
  EXPECT_FALSE(p.asks(0, 2, 2));
  EXPECT_FALSE(p.asks(1, 2, 1));
  EXPECT_EQ(p.capOf(p.suite[0]), 90);
  EXPECT_EQ(p.capOf(p.suite[2]), 10);
}

// Times on different kinds of machines cannot be compared.
TEST_F(SuiteFolder, EachQueryAndSeedIsReportedFromOneKindOfMachine) {
  Plan p = plan();
  auto log = RunLog::open((folder_ / "runs.jsonl").string());
  ASSERT_TRUE(log);
  const auto append = [&](size_t method, const char* machine, double seconds) {
    bench::Run run = plannedRun({p.suite[0], *p.methods[method], 1, p.cap}, 5);
    run.verdict = "solved";
    run.machine = machine;
    run.timing.seconds = seconds;
    return bool(log->append(run));
  };
  ASSERT_TRUE(append(0, "8 lanes", 2) && append(1, "8 lanes", 3) && append(1, "16 lanes", 1));
  EXPECT_EQ(machineOf(p.trialsAt(0, 1), *log, {}).runs, 2u);
  EXPECT_EQ(machineOf(p.trialsAt(0, 2), *log, {}).runs, 0u);
  const Results results = resultsOf(p, *log, {});
  ASSERT_EQ(results.runs[0][0].size(), 1u);
  ASSERT_EQ(results.runs[1][0].size(), 1u);
  EXPECT_EQ(results.runs[0][0][0].timing.seconds, 2);
  EXPECT_EQ(results.runs[1][0][0].timing.seconds, 3);
  p.anyMachine = true;
  EXPECT_EQ(resultsOf(p, *log, {}).runs[1][0].at(0).timing.seconds, 1) << "unless any counts";
}

TEST_F(SuiteFolder, NamesSelectQueriesAndUnknownNamesAreErrors) {
  const auto one = loadSuite(folder_.string(), {"deeper/flat.jsonl:up"});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->size(), 1u);
  EXPECT_FALSE(loadSuite(folder_.string(), {"deeper/flat.jsonl:down"}));
  EXPECT_FALSE(loadSuite((folder_ / "nowhere").string(), {}));
}

TEST_F(SuiteFolder, ARunIsAnswered) {
  const Plan p = plan();
  ThreadPool pool(1);
  const std::atomic<bool> stop{false};
  const Trial trial{p.suite[0], *p.methods[0], 1, 20};
  const auto run = ask(trial, plannedRun(trial, 5), pool, stop);
  ASSERT_TRUE(run) << run.error().text();
  ASSERT_TRUE(*run);
  EXPECT_EQ((*run)->verdict, "solved");
  EXPECT_TRUE((*run)->timing.solved);
  EXPECT_GT((*run)->timing.steps, 0);
  EXPECT_EQ((*run)->key(), plannedRun(trial, 6).key());
}

TEST_F(SuiteFolder, AnInterruptedRunDoesNotCount) {
  const Plan p = plan();
  ThreadPool pool(1);
  const std::atomic<bool> stop{true};
  const Trial trial{p.suite[0], *p.methods[0], 1, 20};
  const auto run = ask(trial, plannedRun(trial, 5), pool, stop);
  ASSERT_TRUE(run);
  EXPECT_FALSE(*run);
}

}  // namespace
}  // namespace obby::bench
