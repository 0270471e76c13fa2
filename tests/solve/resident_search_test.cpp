// Answers of the method `resident`: solutions of levels, and the same bytes on every machine, even
// if the device fails midway.
#include "resident_scenes.h"
#include "solve/methods.h"
#include "support/failing_device.h"
#include "untimed.h"

namespace obby::solve {
namespace {

FilterOptions resident(uint64_t maxSteps, int threads = 2, sim::Device* device = nullptr) {
  FilterOptions o;
  o.threads = threads;
  o.device = device;
  o.solver.method = findMethod("resident");
  o.solver.budget.maxSteps = maxSteps;
  o.solver.budget.attempts = 6;
  o.solver.progressRecords = false;
  return o;
}

Filtered residentSearchAsk(const char* level, FilterOptions options) {
  Filtered f =
      runFilter(std::string(OBBY_SOURCE_DIR "/levels/") + level + ".jsonl", std::move(options));
  EXPECT_TRUE(f.status);
  return f;
}

std::string residentSearchAnswers(const char* level, FilterOptions options) {
  return withoutTiming(residentSearchAsk(level, std::move(options)).output);
}

TEST(ResidentSearch, SameBytesForAnyNumberOfThreadsAndADevice) {
  for (const char* level : {"sliding-planks", "several-routes", "push-box"}) {
    const std::string expected = residentSearchAnswers(level, resident(150'000, 1));
    EXPECT_EQ(residentSearchAnswers(level, resident(150'000, 3)), expected) << level;
    ThreadPool pool(2);
    sim::HostDevice device(pool);
    EXPECT_EQ(residentSearchAnswers(level, resident(150'000, 2, &device)), expected) << level;
  }
}

TEST(ResidentSearch, AFailingDeviceIsGivenUpAndTheAnswersAreTheSame) {
  const std::string expected = residentSearchAnswers("sliding-planks", resident(300'000));
  for (const int launches : {0, 5, 20}) {
    ThreadPool pool(2);
    support::FailingDevice device(pool, launches);
    FilterOptions options = resident(300'000, 2, &device);
    std::vector<std::string> failures;
    options.deviceFailed = [&](const Error& e) { failures.push_back(e.text()); };
    EXPECT_EQ(residentSearchAnswers("sliding-planks", std::move(options)), expected) << launches;
    ASSERT_FALSE(failures.empty());
    EXPECT_EQ(failures.front(), "CUDA: rollout: unspecified launch failure");
  }
}

TEST(ResidentSearch, SolvesLevels) {
  const std::pair<const char*, const char*> queries[] = {
      {"kill-checkerboard", "cross"},
      {"sliding-planks", "cross"},
      {"several-routes", "any"},
      {"several-routes", "no-jumps"},
      {"spiral-tower", "to-half"},
      {"vanishing-run", ""},
      {"truss-tower", ""},
      {"push-box", "onto-the-wall"},
      {"suite/needle-tower", "ten-in-fourteen-jumps"},
  };
  for (const auto& [level, query] : queries) {
    FilterOptions options = resident(4'000'000);
    if (*query != '\0') options.only = {query};
    EXPECT_GE(residentSearchAsk(level, std::move(options)).counts.solved, 1u)
        << level << " " << query;
  }
}

// A known solution is found before the first round.
TEST(ResidentSearch, TriesEarlierAnswersFirst) {
  ResidentScene scene(steppingStones());
  scene.asked.query.goal = boxAt({0, 2, -28}, {8, 4, 8});
  ThreadPool pool(2);
  Problem problem = scene.asked.problem();
  ResidentExplore search(problem, 1, smallRounds(), {pool});
  while (search.goals().empty()) {
    ASSERT_LT(search.statistics().steps, 3'000'000u);
    search.round();
  }
  problem.known = {search.trajectoryTo(search.goals()[0]).actions};
  ResidentExplore again(problem, 2, smallRounds(), {pool});
  again.tryWarmStarts(0, 1);
  ASSERT_EQ(again.goals().size(), 1u);
  EXPECT_EQ(sim::stateHash(again.trajectoryTo(again.goals()[0]).end),
            sim::stateHash(search.trajectoryTo(search.goals()[0]).end));
  EXPECT_GT(again.cellCount(), 5u);
  again.round();
  for (const ArchivedCell& c : again.cells()) {
    ASSERT_EQ(sim::stateHash(again.trajectoryTo(again.nodes()[c.node]).end),
              sim::stateHash(c.world));
  }
  // If a device fails later, the search restarts from the known solutions.
  support::FailingDevice failing(pool, 12);
  ResidentExplore restarted(problem, 2, smallRounds(), {pool, &failing});
  restarted.tryWarmStarts(0, 1);
  restarted.round();
  EXPECT_FALSE(restarted.deviceStatus());
  expectSameArchive(restarted, again, "restarted");
}

// Every rollout counts as an attempt, and sampled attempts end with the outcome that they state.
TEST(ResidentSearch, CountsHowAttemptsEnd) {
  ResidentScene scene(steppingStones());
  ThreadPool pool(2);
  ResidentExplore search(scene.asked.problem(), 3, smallRounds(), {pool});
  for (int i = 0; i < 5; ++i) search.round();
  uint64_t ends = 0;
  for (const EndCount& e : search.attempts().counts()) ends += e.count;
  EXPECT_EQ(ends, search.statistics().rollouts);
  for (const AttemptEnd& e : search.attempts().sample(20, {})) {
    EXPECT_EQ(search.trajectoryTo(e.node).end.outcome, e.outcome);
  }
}

}  // namespace
}  // namespace obby::solve
