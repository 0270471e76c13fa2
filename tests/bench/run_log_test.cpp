// The log of bench_solve recognises finished runs. Runs that were cut off are repeated.
#include "suite/run_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace obby::bench {
namespace {

Run someRun() {
  bench::Run run;
  run.method = "auto";
  run.file = "teaser.jsonl";
  run.query = "over \"the\" wall";
  run.verdict = "solved";
  run.expected = "solved";
  run.seed = 3;
  run.cap = 90;
  run.content = 0xfedcba9876543210u;
  run.program = 77;
  run.threads = 2;
  run.machine = "AMD EPYC, 8 lanes";
  run.timing = {1.25, true, 2846991, 68};
  return run;
}

class RunLogFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    path_ = (folder_ / "deeper" / "runs.jsonl").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::string path_;
};

TEST(RunLine, RoundTrips) {
  const bench::Run run = someRun();
  const auto back = parseRun(runLine(run));
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(runLine(*back), runLine(run));
  EXPECT_EQ(back->content, run.content);
  EXPECT_EQ(back->query, run.query);
  EXPECT_TRUE(back->timing.solved);
}

TEST(RunLine, MayOmitTheMachine) {
  std::string line = runLine(someRun());
  const std::string field = "\"machine\":\"AMD EPYC, 8 lanes\",";
  const size_t at = line.find(field);
  ASSERT_NE(at, std::string::npos) << line;
  line.erase(at, field.size());
  const auto back = parseRun(line);
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(back->machine, "");
}

TEST(RunLine, LinesWithoutAFieldAreIgnored) {
  EXPECT_FALSE(parseRun("{\"method\":\"auto\"}"));
  EXPECT_FALSE(parseRun("[1,2]"));
  EXPECT_FALSE(parseRun(""));
}

TEST(RunKey, HasMethodQuerySeedAndCapButNoResults) {
  const bench::Run run = someRun();
  bench::Run other = run;
  other.timing.seconds = 9;
  other.program = 78;
  EXPECT_EQ(other.key(), run.key());
  other = run, other.method = "ge";
  EXPECT_NE(other.key(), run.key());
  other = run, other.content = 1;
  EXPECT_NE(other.key(), run.key());
  other = run, other.seed = 4;
  EXPECT_NE(other.key(), run.key());
  other = run, other.cap = 10;
  EXPECT_NE(other.key(), run.key());
}

TEST_F(RunLogFile, RunsAreFoundByTheSameProgramOnly) {
  const bench::Run run = someRun();
  {
    auto log = RunLog::open(path_);
    ASSERT_TRUE(log);
    ASSERT_TRUE(log->append(run));
    EXPECT_NE(log->find(run.key(), {run.program, 2}), nullptr);
  }
  const auto again = RunLog::open(path_);
  ASSERT_TRUE(again);
  EXPECT_NE(again->find(run.key(), {run.program, 2}), nullptr);
  EXPECT_EQ(again->find(run.key(), {run.program + 1, 2}), nullptr);
  EXPECT_EQ(again->find(run.key(), {run.program, 1}), nullptr) << "one thread takes longer";
  EXPECT_NE(again->find(run.key(), {}), nullptr);
}

TEST_F(RunLogFile, TheLastRunOfAKeyCounts) {
  auto log = RunLog::open(path_);
  ASSERT_TRUE(log);
  bench::Run run = someRun();
  ASSERT_TRUE(log->append(run));
  run.timing.seconds = 2;
  ASSERT_TRUE(log->append(run));
  EXPECT_EQ(log->find(run.key(), {})->timing.seconds, 2);
}

// For one query and seed, the runs of all methods must come from one kind of machine.
TEST_F(RunLogFile, FindsTheMachineWithTheMostRuns) {
  auto log = RunLog::open(path_);
  ASSERT_TRUE(log);
  bench::Run run = someRun();
  std::vector<std::string> keys;
  for (const char* method : {"ge", "rl", "pbge"}) {
    run.method = method;
    keys.push_back(run.key());
  }
  EXPECT_EQ(log->mostlyBy(keys, {}).runs, 0u);
  const auto append = [&](const char* method, const char* machine) {
    run.method = method;
    run.machine = machine;
    return bool(log->append(run));
  };
  ASSERT_TRUE(append("ge", "8 lanes") && append("rl", "8 lanes") && append("ge", "8 lanes"));
  EXPECT_EQ(log->mostlyBy(keys, {}).runs, 2u) << "a run that was made twice is one";
  ASSERT_TRUE(append("ge", "16 lanes"));
  EXPECT_EQ(log->mostlyBy(keys, {}).machine, "8 lanes");
  ASSERT_TRUE(append("pbge", "16 lanes"));
  EXPECT_EQ(log->mostlyBy(keys, {}).machine, "16 lanes")
      << "the later one of two that made as many";
  EXPECT_EQ(log->mostlyBy(keys, {0, run.threads + 1}).runs, 0u);
  EXPECT_EQ(log->find(keys[0], {0, 0, "8 lanes"})->machine, "8 lanes");
  EXPECT_EQ(log->find(keys[2], {0, 0, "8 lanes"}), nullptr);
}

TEST_F(RunLogFile, ContinuesAfterATruncatedLine) {
  bench::Run run = someRun();
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path());
  std::ofstream(path_, std::ios::binary) << runLine(run) << runLine(run).substr(0, 40);
  run.seed = 4;
  {
    auto log = RunLog::open(path_);
    ASSERT_TRUE(log);
    EXPECT_EQ(log->unreadable(), 1u);
    ASSERT_TRUE(log->append(run));
  }
  const auto again = RunLog::open(path_);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->unreadable(), 1u);
  EXPECT_NE(again->find(run.key(), {}), nullptr);
  EXPECT_NE(again->find(someRun().key(), {}), nullptr);
}

TEST_F(RunLogFile, AFolderInItsPlaceIsAnErrorThatNamesIt) {
  std::filesystem::create_directories(path_);
  auto log = RunLog::open(path_);
  const Status status = log ? log->append(someRun()) : Status(log.error());
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().text().find("runs.jsonl"), std::string::npos);
}

}  // namespace
}  // namespace obby::bench
