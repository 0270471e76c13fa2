// A search can return several solutions that take different routes.
#include <gtest/gtest.h>

#include <set>

#include "hand_played.h"
#include "io/json_codec.h"
#include "solve/search/solutions.h"
#include "untimed.h"

namespace obby::solve {
namespace {

using Route = std::vector<int32_t>;

// Returns a course that spends five ticks on each carrier in `parts`. `reached` holds the number of
// waypoints passed before the player is on each carrier.
Course carriedBy(const Problem& problem, const Route& parts, std::vector<uint8_t> reached = {}) {
  Course course;
  reached.resize(parts.size());
  for (size_t i = 0; i < parts.size(); ++i) {
    for (int t = 0; t < 5; ++t) {
      sim::World world = problem.start;
      world.waypoints = reached[i];
      course.carriers.push_back(parts[i]);
      course.replay.worlds.push_back(world);
    }
  }
  course.actions.resize(course.carriers.size() - 1);
  return course;
}

struct Stones {
  level::Level level = steppingStones().compile();
  PlainQuery asked{level};
  Problem problem = asked.problem();
};

TEST(DirectRoute, SteppingBackIsNotAnotherRoute) {
  Stones s;
  const auto direct = [&](const Route& parts) {
    return directRouteOf(s.problem, carriedBy(s.problem, parts));
  };
  EXPECT_EQ(direct({2, 1, 0}), (Route{2, 1, 0}));
  EXPECT_EQ(direct({2, 1, 2, 0}), (Route{2, 0}));
  EXPECT_EQ(direct({2, 1, 2, 1, 0}), (Route{2, 1, 0}));
  EXPECT_EQ(direct({2, 1, -1, 3, 1, 2, -1, 0}), (Route{2, 0}));
  EXPECT_EQ(direct({2, 1, 3, 2, 0}), (Route{2, 1, 3, 2, 0}));
}

TEST(DirectRoute, SteppingAsideForAWaypointIsNoDetour) {
  Stones s;
  const Course course = carriedBy(s.problem, {2, 1, 2, 0}, {0, 1, 1, 1});
  EXPECT_EQ(directRouteOf(s.problem, course), (Route{2, 1, 2, 0}));
}

TEST(DirectRoute, EndsAtTheLanding) {
  GapScene scene(5);
  scene.problem.query.goal = boxAt({0, 4, -14}, {8, 4, 6});  // the goal is reached in the air
  const Course course = scene.jumpAt(-7);
  ASSERT_EQ(course.replay.worlds.back().outcome, sim::Outcome::goal);
  ASSERT_EQ(routeOf(course), (Route{0}));
  EXPECT_EQ(directRouteOf(scene.problem, course), (Route{0, 1}));
}

Trajectory played(const Problem& problem, uint32_t waitTicks) {
  return playByHand(problem, [=](const sim::World& w) {
    const float z = w.position.z;
    return sim::Action{0, w.tick >= waitTicks, (z < -7 && z > -9) || (z < -19 && z > -21)};
  });
}

TEST(Solutions, KeepTheShortestPerRouteAndCountAll) {
  Stones s;
  Solutions solutions(s.problem, byRoute());
  int asked = 0;
  const auto accept = [&](const Trajectory&) { return ++asked > 0; };
  EXPECT_EQ(solutions.offer(played(s.problem, 30), accept), Solutions::Offer::kept);
  EXPECT_EQ(solutions.offer(played(s.problem, 60), accept), Solutions::Offer::known);
  EXPECT_EQ(solutions.offer(played(s.problem, 0), accept), Solutions::Offer::kept);
  EXPECT_EQ(asked, 2);
  ASSERT_EQ(solutions.count(), 1u);
  const auto routes = solutions.routes();
  ASSERT_EQ(routes.size(), 1u);
  EXPECT_EQ(routes[0].route, (Route{0, 1, 2}));
  EXPECT_EQ(routes[0].count, 3u);
  EXPECT_EQ(routes[0].ticks, played(s.problem, 0).ticks);
}

Solution routed(Route route) { return {Trajectory{}, std::move(route), 1}; }

TEST(SolutionIdentity, ARouteStaysTheSameWithOneMorePart) {
  const auto same = [](const Route& a, const Route& b) {
    EXPECT_EQ(byRoute().same(routed(a), routed(b)), byRoute().same(routed(b), routed(a)));
    return byRoute().same(routed(a), routed(b));
  };
  EXPECT_TRUE(same({0, 1, 3}, {0, 1, 3}));
  EXPECT_TRUE(same({0, 2, 1, 3}, {0, 1, 3}));
  EXPECT_TRUE(same({0, 1, 3}, {0, 1, 3, 4}));
  EXPECT_TRUE(same({0, 1}, {2, 0, 1}));
  EXPECT_FALSE(same({0, 1, 3}, {0, 2, 3}));
  EXPECT_FALSE(same({0, 1, 3}, {0, 3, 1}));
  EXPECT_FALSE(same({0, 1, 2, 3}, {0, 3}));
  EXPECT_FALSE(same({0, 1, 2, 3}, {0, 2, 1}));
}

TEST(Solutions, ARefusedTrajectoryIsNotCounted) {
  Stones s;
  Solutions solutions(s.problem, byRoute());
  const auto refuse = [](const Trajectory&) { return false; };
  EXPECT_EQ(solutions.offer(played(s.problem, 0), refuse), Solutions::Offer::refused);
  EXPECT_EQ(solutions.count(), 0u);
  EXPECT_TRUE(solutions.routes().empty());
}

// Returns a level with two routes over a gap: by a stone on the left or on the right.
std::string forkText() {
  return R"({"type":"level","name":"fork","physics":{"fallenPartsHeight":-40},"parts":[)"
         R"({"name":"A","position":[0,-0.5,-4],"size":[20,1,8]},)"
         R"({"name":"Left","position":[-7,-0.5,-18],"size":[4,1,4]},)"
         R"({"name":"Right","position":[7,-0.5,-18],"size":[4,1,4]},)"
         R"({"name":"B","position":[0,-0.5,-32],"size":[20,1,8]}],)"
         R"("spawns":[{"position":[0,0,-2]}]})"
         "\n"
         R"({"type":"query","id":"q","goal":{"position":[0,1,-34],"size":[20,2,4]}})"
         "\n";
}

FilterOptions diverse(uint32_t solutions, int threads = 2) {
  FilterOptions o;
  o.threads = threads;
  o.solver.progressRecords = false;
  o.solver.budget.maxSteps = 2'000'000;
  o.solver.budget.attempts = 0;
  o.solver.budget.solutions = solutions;
  o.solver.budget.diverse = true;
  return o;
}

std::string solveFork(FilterOptions options) {
  const LinesFile file(forkText());
  const Filtered f = runFilter(file.path(), std::move(options));
  EXPECT_TRUE(f.status) << f.status.error().text();
  return withoutTiming(f.output);
}

TEST(Diverse, BothSidesOfAForkAreFoundOnceEach) {
  const std::string output = solveFork(diverse(2));
  std::set<Route> seen;
  uint32_t trajectories = 0;
  size_t at = 0;
  for (size_t end; (end = output.find('\n', at)) != std::string::npos; at = end + 1) {
    const auto record = io::recordFromJson(output.substr(at, end - at));
    ASSERT_TRUE(record);
    trajectories += record->reader().isTrajectory();
    if (!record->reader().isResult()) continue;
    uint64_t last = ~0ull;
    for (const auto r : record->reader().getResult().getRoutes()) {
      Route parts;
      for (const int32_t part : r.getRoute()) parts.push_back(part);
      seen.insert(parts);
      EXPECT_GE(r.getCount(), 1u);
      EXPECT_LE(r.getCount(), last);
      last = r.getCount();
    }
  }
  EXPECT_EQ(trajectories, 2u);
  EXPECT_EQ(seen, (std::set<Route>{{0, 1, 3}, {0, 2, 3}}));
}

TEST(Diverse, SameBytesForAnyNumberOfThreads) {
  EXPECT_EQ(solveFork(diverse(3, 1)), solveFork(diverse(3, 3)));
}

}  // namespace
}  // namespace obby::solve
