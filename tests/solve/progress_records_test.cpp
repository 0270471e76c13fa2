// The records that a search shows while it runs.
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"
#include "solve/report/answer_records.h"
#include "solve/search/methods/go_explore.h"

namespace obby::solve {
namespace {

// This goal is far out of reach.
constexpr Vec3 kProgressRecordsGoal{0, 60, -28}, kGoalSize{8, 4, 8};

std::string lineOf(const io::RecordBuilder& record) {
  return *io::recordToJson(record.reader()) + "\n";
}

std::string lineOf(schema::Trajectory::Reader trajectory) {
  io::RecordBuilder record;
  record.root().setTrajectory(trajectory);
  return lineOf(record);
}

struct Searched {
  io::RecordBuilder record;
  schema::Progress::Reader progress;
};

Searched searched(int rounds, bool paths = false) {
  static const level::Level level = steppingStones().compile();
  PlainQuery asked(level);
  asked.query.goal = boxAt(kProgressRecordsGoal, kGoalSize);
  const Problem problem = asked.problem();
  ThreadPool pool(1);
  GoExplore search(problem, 1, {}, pool);
  for (int round = 0; round < rounds; ++round) search.round();
  Searched s;
  fillProgress(s.record.root().initProgress(), {"q", "stones", level.spawns()[0], "ge"},
               {search, 0.5}, paths);
  s.progress = s.record.reader().getProgress();
  return s;
}

TEST(ProgressRecord, ShowsTheClosestTheNewestAndDeaths) {
  const Searched s = searched(60);
  ASSERT_TRUE(s.progress.hasBest());
  ASSERT_TRUE(s.progress.hasNewest());
  EXPECT_EQ(s.progress.getNewest().getOutcome(), schema::Outcome::RUNNING);
  ASSERT_EQ(s.progress.getDeaths().size(), 3u);
  for (const auto death : s.progress.getDeaths()) {
    EXPECT_EQ(death.getOutcome(), schema::Outcome::FELL);
  }
  EXPECT_NE(s.progress.getDeaths()[0].getStateHash(), s.progress.getDeaths()[1].getStateHash());
}

// Expects the points of the record's path to equal the replay of its actions.
void expectPathOfReplay(schema::Trajectory::Reader trajectory) {
  const level::Level level = steppingStones().compile();
  const auto plan = sim::planFromRecord(trajectory);
  ASSERT_TRUE(plan);
  const auto worlds = sim::replay(level.view(), nullptr, *plan).worlds;
  const auto path = trajectory.getPath();
  const uint32_t ticks = trajectory.getTicks(), step = path.getStep();
  ASSERT_EQ(path.getTicks(), ticks);
  ASSERT_EQ(path.getPoints().size(), (ticks + step - 1) / step + 1) << "the end is a point, too";
  for (uint32_t i = 0; i < path.getPoints().size(); ++i) {
    const Vec3 feet = worlds[std::min(i * step, ticks)].position;
    EXPECT_EQ(path.getPoints()[i].getX(), feet.x);
    EXPECT_EQ(path.getPoints()[i].getY(), feet.y);
    EXPECT_EQ(path.getPoints()[i].getZ(), feet.z);
  }
  ASSERT_EQ(path.getJumpTicks().size(), trajectory.getJumps());
  for (const uint32_t tick : path.getJumpTicks()) {
    EXPECT_EQ(worlds[tick].jumps, worlds[tick - 1].jumps + 1);
  }
}

TEST(ProgressRecord, PathsEqualTheReplayAndAreOptional) {
  const Searched s = searched(60, true);
  expectPathOfReplay(s.progress.getBest());
  expectPathOfReplay(s.progress.getNewest());
  uint32_t betweenPoints = 0;
  for (const auto death : s.progress.getDeaths()) {
    expectPathOfReplay(death);
    betweenPoints += death.getTicks() % death.getPath().getStep() != 0;
  }
  EXPECT_GT(betweenPoints, 0u) << "one must end between two points for this to show anything";
  EXPECT_GT(s.progress.getBest().getJumps(), 0u);
  EXPECT_FALSE(searched(60).progress.getBest().hasPath());
}

TEST(ProgressRecord, EveryTrajectoryReplays) {
  const Searched s = searched(60);
  std::string text = stonesText();
  text.replace(text.find(R"("position":[0,2,-28])"), 20, R"("position":[0,60,-28])");
  text += lineOf(s.progress.getBest()) + lineOf(s.progress.getNewest());
  for (const auto death : s.progress.getDeaths()) text += lineOf(death);
  const LinesFile file(text);
  FilterOptions verify;
  verify.task = Task::verify;
  const Filtered checked = runFilter(file.path(), verify);
  EXPECT_TRUE(checked.status) << checked.status.error().text();
  EXPECT_EQ(checked.counts.verified, 2 + s.progress.getDeaths().size());
}

TEST(ProgressRecord, ShowsNothingBeforeTheFirstRound) {
  const Searched s = searched(0);
  EXPECT_FALSE(s.progress.hasBest());
  EXPECT_FALSE(s.progress.hasNewest());
  EXPECT_EQ(s.progress.getDeaths().size(), 0u);
}

}  // namespace
}  // namespace obby::solve
