// The bound on reach holds what random players do in random levels: parts of every shape and role,
// thrown about so widely that some are out of reach.
#include <gtest/gtest.h>

#if __has_include(<rapidcheck.h>)
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <sstream>

#include "sim/random_level.h"
#include "solve/go_explore.h"
#include "solve/proof/reach_bound.h"

namespace obby::test {
namespace {

// Before rapidcheck reads it, at the first property.
const int kSeeded = setenv("RC_PARAMS", "seed=20 max_success=200 max_discard_ratio=50", 0);

// A platform to start from, and parts around it.
Result<level::Level> scattered(std::vector<PartSpec> specs) {
  for (PartSpec& s : specs) s.position = mul(s.position, {4, 2, 4});
  specs.push_back({0, {0, -1, 0}, {6, 2, 6}, {0, 0, 0}, 0});
  return compile(specs);
}

std::string placeOf(const sim::World& w) {
  std::ostringstream out;
  showValue(w.position, out);
  return " in state " + std::to_string(int(w.state)) + " at " + out.str();
}

solve::Problem reachPropertyProblemOf(const level::Level& level) {
  level::QueryView query;
  query.goal.region = {{{0, 5000, 0}, {}}, {1, 1, 1}};
  return {level.view(), query,          sim::makeWorld(level.view(), level.spawns()[0]),
          {},           level.bounds(), level.hasMotion()};
}

RC_GTEST_PROP(ReachProperties, NobodyLeavesTheBound, ()) {
  const auto level = scattered(*rc::gen::container<std::vector<PartSpec>>(12, partSpecs()));
  const bool bounded = level && solve::unboundedPart(level->view()) == nullptr;
  RC_PRE(bounded);
  const solve::Problem problem = reachPropertyProblemOf(*level);
  const solve::ReachBound bound(problem, true);
  const uint64_t seed = *rc::gen::inRange<uint64_t>(0, 100000);
  for (uint64_t i = 0; i < 8; ++i) {
    sim::World w = problem.start;
    for (uint32_t t = 0; t < 400 && w.outcome == sim::Outcome::running; ++t) {
      sim::advance(w, nullptr, level->view(), nullptr, actionAt(seed + i, t));
      if (!bound.holds(w.position)) RC_FAIL("tick " + std::to_string(t) + placeOf(w));
    }
  }
}

// A search looks for the ways out.
RC_GTEST_PROP(ReachProperties, NoSearchLeavesTheBound, ()) {
  const auto level = scattered(*rc::gen::container<std::vector<PartSpec>>(14, partSpecs()));
  const bool bounded = level && solve::unboundedPart(level->view()) == nullptr;
  RC_PRE(bounded);
  const solve::Problem problem = reachPropertyProblemOf(*level);
  const solve::ReachBound bound(problem, true);
  ThreadPool pool(1);
  solve::GoExplore search(problem, 1, {}, {pool});
  for (int round = 0; round < 10; ++round) search.round();
  for (uint32_t c = 0; c < search.archive().cellCount(); ++c) {
    const sim::World& w = search.archive().world(c);
    if (!bound.holds(w.position)) RC_FAIL("cell " + std::to_string(c) + placeOf(w));
  }
}

}  // namespace
}  // namespace obby::test

#else

TEST(ReachProperties, NobodyLeavesTheBound) {
  GTEST_SKIP() << "built without librapidcheck-dev (scripts/setup test)";
}

#endif
