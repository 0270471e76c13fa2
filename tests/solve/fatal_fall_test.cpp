// A search gives up players who have fallen below all parts. None of these players could have
// returned.
#include "solve/search/rollouts/fatal_fall.h"

#include <gtest/gtest.h>

#include "scenes.h"
#include "solve/search/methods/go_explore.h"
#include "solve/search/rollouts/rollout.h"

namespace obby::solve {
namespace {

TEST(FatalFall, LiesBelowThePartsTheRegionsAndTheStart) {
  LevelBuilder b = steppingStones();
  const level::Level stones = b.compile();
  PlainQuery q(stones);
  const float alone = fatalHeight(q.problem());
  EXPECT_LT(alone, -1 - stones.view().params.bodyTop);
  q.query.goal = boxAt({0, -20, -28}, {8, 4, 8});
  EXPECT_NEAR(fatalHeight(q.problem()), alone - 21, 1e-4f);
  q.query.goal = boxAt({0, 2, -28}, {8, 4, 8});
  q.avoid.push_back(boxAt({0, -29, 0}, {1, 2, 1}));
  EXPECT_NEAR(fatalHeight(q.problem()), alone - 29, 1e-4f);
}

TEST(FatalFall, CoversTheWholeMotionOfAMover) {
  LevelBuilder b = steppingStones();
  const level::Level still = b.compile();
  b.block({0, -0.5f, -40}, {4, 1, 4}, [](schema::Part::Builder p) {
    auto keys = p.initMotion().initKeys(2);
    support::set(keys[0].initPosition(), {0, -0.5f, -40});
    support::set(keys[1].initPosition(), {0, -30.5f, -40});
    keys[1].setTime(3);
    p.getMotion().setRepeat(schema::Repeat::PING_PONG);
  });
  const level::Level lift = b.compile();
  EXPECT_NEAR(fatalHeight(PlainQuery(lift).problem()),
              fatalHeight(PlainQuery(still).problem()) - 30, 0.1f);
}

// Continues random rollouts after the search has given them up. All players fall without touching
// anything.
TEST(FatalFall, PlayersThatAreGivenUpFall) {
  LevelBuilder b = steppingStones();
  b.physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-60); });
  const level::Level stones = b.compile();
  PlainQuery q(stones);
  q.query.goal = boxAt({0, 60, -28}, {4, 4, 4});
  const Problem problem = q.problem();
  ThreadPool pool(1);
  const GoExplore search(problem, 1, {}, pool);
  int doomedCount = 0;
  for (uint64_t stream = 0; stream < 500; ++stream) {
    sim::World given = problem.start, whole = problem.start;
    const auto nothing = [](const sim::Action&, const sim::World&) {};
    runRollout(search.context(), 1, stream, given, nullptr, 600, nothing);
    runRollout<true, true>(search.context(), 1, stream, whole, nullptr, 1200, nothing);
    if (given.outcome != sim::Outcome::running || given.tick == 600) continue;
    ++doomedCount;
    EXPECT_EQ(whole.outcome, sim::Outcome::fell);
    EXPECT_GT(whole.tick, given.tick);
    EXPECT_LT(given.position.y, fatalHeight(problem));
  }
  EXPECT_GT(doomedCount, 100);
}

// The answer hides this optimisation: attempts that were given up are shown to the end of their
// fall.
TEST(FatalFall, AttemptsAreShownToTheEndOfTheirFall) {
  const LinesFile file(stonesText(R"(,"avoid":[{"position":[0,0,-10],"size":[200,200,1]}])"));
  FilterOptions o;
  o.solver.budget.maxSteps = 100'000;
  o.solver.progressRecords = false;
  const Filtered f = runFilter(file.path(), o);
  ASSERT_TRUE(f.status);
  EXPECT_NE(f.output.find("\"outcome\":\"fell\",\"position\""), std::string::npos);
  FilterOptions verify;
  verify.task = Task::verify;
  const LinesFile answered(f.output);
  const Filtered checked = runFilter(answered.path(), verify);
  EXPECT_TRUE(checked.status) << checked.status.error().text();
}

}  // namespace
}  // namespace obby::solve
