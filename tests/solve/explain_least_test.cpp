// Tests that a change is reduced to the necessary amount, even if searches miss some solutions.
#include <gtest/gtest.h>

#include "hand_played.h"
#include "io/json_codec.h"
#include "solve/report/relaxation/explain.h"

namespace obby::solve {
namespace {

io::RecordBuilder record(const std::string& json) {
  auto decoded = io::recordFromJson(json);
  EXPECT_TRUE(decoded) << decoded.error().text();
  return *std::move(decoded);
}

// A floor that the player can walk along without jumping.
constexpr const char* kLevel =
    R"({"type":"level","name":"scene","parts":[{"name":"Floor","position":[0,-0.5,-15],)"
    R"("size":[8,1,38]}],"spawns":[{"position":[0,0,-2]}]})";
constexpr const char* kQuery =
    R"({"type":"query","id":"q","maxJumps":1,"goal":{"position":[0,2,-30],"size":[8,4,4]}})";

// Returns a trajectory with this number of jumps on the spot, followed by a walk to the goal.
Trajectory jumpedThenWalked(const Problem& problem, int jumps) {
  return playByHand(problem, [=](const sim::World& w) {
    if (int(w.jumps) < jumps) return sim::Action{0, false, true};
    return sim::Action{0, w.position.y < 0.3f, false};
  });
}

int searches = 0;  // searches that allow more jumps than the query

// A search that misses solutions. With one or five jumps allowed, the search finds no solution.
// With seven it finds one of three jumps, and otherwise one of nine.
SearchOutcome missing(const Problem& problem, const Budget&, const Watcher& watcher,
                      const Machine&) {
  SearchOutcome outcome;
  outcome.stopped = Stopped::outOfSteps;
  outcome.statistics.steps = 1000;
  const int32_t max = problem.query.maxJumps;
  if (max == 1) return outcome;
  ++searches;
  if (max == 5) return outcome;
  Trajectory p = jumpedThenWalked(problem, max == 7 ? 3 : 9);
  if (watcher.accept(p)) outcome.solutions.push_back(std::move(p));
  return outcome;
}

TEST(Explain, ReducesAChangeDespiteMissedSolutions) {
  const io::RecordBuilder levelRecord = record(kLevel), queryRecord = record(kQuery);
  const auto level = level::Level::compile(levelRecord.reader().getLevel());
  ASSERT_TRUE(level);
  const auto query = level::Query::compile(queryRecord.reader().getQuery(), *level);
  ASSERT_TRUE(query);
  const PosedQuery posed{*level, levelRecord.reader().getLevel(), *query,
                         queryRecord.reader().getQuery()};
  const SearchOutcome outcome{};
  const Footprints footprints{};
  Budget budget;
  budget.maxSteps = 100'000;
  ThreadPool pool(1);
  searches = 0;
  const auto found =
      explain({posed, outcome, footprints}, {"missing", "", missing}, budget, Machine(pool));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, schema::RelaxationKind::JUMPS);
  EXPECT_EQ(found[0].amount, 2);
  EXPECT_EQ(searches, 3);
}

}  // namespace
}  // namespace obby::solve
