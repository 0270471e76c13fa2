// Queries for players that walk in the keyboard's eight directions.
#include <gtest/gtest.h>

#include "scenes.h"
#include "solve/methods.h"
#include "solve/query_solver.h"

namespace obby::solve {
namespace {

constexpr int32_t kEighth = 65536 / 8;

// Returns the solutions for a gap that lies diagonally to the initial facing.
std::vector<io::Record> solutionsOf(schema::Directions directions) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).block({5, -0.5f, -14}, {6, 1, 8});
  b.spawn({0, 0, 2}, 0.3f);
  io::RecordBuilder level, query;
  level.root().setLevel(b.record());
  auto q = query.root().initQuery();
  q.setDirections(directions);
  auto goal = q.initGoal();
  support::set(goal.initPosition(), {5, 2, -14});
  support::set(goal.initSize(), {6, 4, 8});
  std::vector<io::Record> solutions;
  const auto loaded = loadLevel(io::Record(std::move(level)));
  EXPECT_TRUE(loaded);
  SolverOptions options;
  options.method = findMethod("auto");
  ThreadPool pool(1);
  const SolverOutput output{[&](schema::Record::Reader record) -> Status {
                              if (!record.isTrajectory()) return {};
                              solutions.emplace_back(io::RecordBuilder(record));
                              return {};
                            },
                            {},
                            {}};
  const auto answer =
      solveQuery(*loaded, query.reader().getQuery(), options, {pool, nullptr}, output);
  EXPECT_TRUE(answer && answer->verdict == schema::Verdict::SOLVED);
  return solutions;
}

bool isByKeys(schema::Trajectory::Reader t) {
  for (const auto action : t.getActions()) {
    if (action.getWalk() && (int32_t(action.getHeading()) - t.getYawTurns()) % kEighth != 0)
      return false;
  }
  return true;
}

TEST(Directions, KeyboardSolutionsWalkInEightOnly) {
  const auto solutions = solutionsOf(schema::Directions::KEYBOARD);
  ASSERT_FALSE(solutions.empty());
  for (const io::Record& s : solutions) EXPECT_TRUE(isByKeys(s.reader().getTrajectory()));
}

TEST(Directions, AreFreeOtherwise) {
  const auto solutions = solutionsOf(schema::Directions::ANY);
  ASSERT_FALSE(solutions.empty());
  EXPECT_FALSE(isByKeys(solutions.front().reader().getTrajectory()));
}

}  // namespace
}  // namespace obby::solve
