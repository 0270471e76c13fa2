// Tests a query whose answer cannot be written.
#include "solve/query_solver.h"
#include "solve/methods.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace obby::solve {
namespace {

// Returns a level and query whose goal is far out of reach. The dynamic parts prevent a proof that
// it is unreachable.
io::RecordBuilder hopelessLevel() {
  LevelBuilder b = steppingStones();
  b.block({3, 1, -4}, {1, 1, 1}, [](auto part) { part.setAnchored(false); });
  io::RecordBuilder record;
  record.root().setLevel(b.record());
  return record;
}

TEST(QuerySolver, ASearchEndsIfItsOutputFails) {
  const auto level = loadLevel(io::Record(hopelessLevel()));
  ASSERT_TRUE(level) << level.error().text();
  io::RecordBuilder query;
  auto goal = query.root().initQuery().initGoal();
  support::set(goal.initPosition(), {0, 60, -28});
  support::set(goal.initSize(), {8, 4, 8});
  SolverOptions options;
  options.method = findMethod("auto");
  options.budget.seconds = 1e9;
  ThreadPool pool(1);
  int asked = 0;
  const SolverOutput output{[&](schema::Record::Reader) -> Status {
                              ++asked;
                              return makeError("nobody reads");
                            },
                            {},
                            {}};
  const auto answer =
      solveQuery(*level, query.reader().getQuery(), options, {pool, nullptr}, output);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().message, "nobody reads");
  EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace obby::solve
