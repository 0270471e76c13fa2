// Finds the hardest step that a search solves. A level has one step, whose difficulty is a number
// of studs. The search starts at an easy step and makes it harder.
#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "solve/search/methods/go_explore.h"
#include "support/level_builder.h"
#include "support/plain_problem.h"

namespace obby::support {

using solve::Problem;

// index of the part that is the goal
inline constexpr uint32_t kTarget = 1;  // the part that is the goal

struct Scene {
  support::LevelBuilder level;
  Box goal;
};

using Build = std::function<Scene(float)>;

inline Scene platforms(float gap, float rise) {
  Scene s;
  const Vec3 at{0, rise - 4, -8 - gap};
  s.level.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 2}).block(at, {8, 8, 8});
  s.goal = {{-4, rise, at.z - 4}, {4, rise + 4, at.z + 4}};
  return s;
}

// Returns the region above this floor that only the head of a standing player reaches.
inline Box overhead(Box floor) {
  return {floor.lo + Vec3{0, 4.9f, 0}, {floor.hi.x, floor.lo.y + 8, floor.hi.z}};
}

// Adds a part that moves back and forth, two seconds each way.
inline void slide(Scene& s, Vec3 from, Vec3 to, bool carries) {
  s.level.block(from, {6, 1, 6}, [=](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(carries);
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), from);
    support::set(keys[1].initPosition(), to);
    keys[1].setTime(2);
  });
}

// Returns a step from a moving platform to a static one. The platform moves by `by`, and the gap is
// `gap` at the end of its motion.
inline Scene off(Vec3 by, float gap, bool carries = true) {
  Scene s;
  slide(s, {0, -0.5f, 0}, {by.x, by.y - 0.5f, by.z}, carries);
  const float z = by.z - 3 - gap - 4;
  s.level.spawn({0, 0, 2}).block({0.5f * by.x, by.y - 0.5f, z}, {8, 1, 8});
  s.goal = overhead({{0.5f * by.x - 4, by.y, z - 4}, {0.5f * by.x + 4, by.y, z + 4}});
  return s;
}

// Returns a step from a static platform to a moving one, which moves by `by`. The gap is `gap` at
// the near end of its motion.
inline Scene onto(Vec3 by, float gap) {
  Scene s;
  const Vec3 near{-0.5f * by.x, -0.5f, -4 - gap - 3};
  s.level.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 2});
  slide(s, near, near + by, true);
  const Vec3 half{3, -0.5f, 3};
  s.goal = overhead({min(near, near + by) - half, max(near, near + by) + half});
  return s;
}

inline level::QueryView queryFor(const Scene& s) {
  level::QueryView q;
  q.goal.region = {{(s.goal.lo + s.goal.hi) * 0.5f, {}}, (s.goal.hi - s.goal.lo) * 0.5f};
  return q;
}

using Actions = std::vector<sim::Action>;

// Returns the shortest distance to the goal under these actions, in studs, or 0 if they reach the
// goal.
inline float missOf(const Problem& problem, const Actions& actions) {
  sim::World w = problem.start;
  float lowest = 1e30f;
  for (const sim::Action& a : actions) {
    sim::advance(w, nullptr, problem.level, &problem.query, a);
    if (w.outcome == sim::Outcome::goal) return 0;
    if (w.outcome != sim::Outcome::running) break;
    lowest = std::min(lowest, geom::distance(problem.query.goal.region, w.position));
  }
  return lowest;
}

// Returns changed actions, with other headings for a while, or with a tick more or less.
inline Actions changed(const Actions& from, Random& random) {
  Actions to = from;
  const auto any = [&] { return random.below(uint32_t(to.size())); };
  for (uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
    const uint32_t at = any(), count = 1 + random.below(random.below(2) == 0 ? 4 : 30);
    switch (random.below(5)) {
      case 0: to.insert(to.begin() + at, to[at]); break;
      case 1: to.erase(to.begin() + at); break;
      case 2: std::swap(to[at].jump, to[any()].jump); break;
      default: {
        const auto by = Turns(int32_t(random.below(2 * 8192)) - 8192);
        const auto heading = Turns(random.below(4) == 0 ? random.next() : to[at].heading + by);
        for (uint32_t i = at; i < to.size() && i < at + count; ++i) to[i].heading = heading;
      }
    }
    if (to.size() < 10) return from;
  }
  to.resize(from.size(), to.back());
  return to;
}

// Returns the hardest step, of at least `studs`, that mutations of these actions solve.
inline float climb(const Build& build, float studs, float enough, Actions actions, uint64_t steps) {
  constexpr float kHarder = 0.02f;
  Random random(5, 5);
  actions.resize(actions.size() + 20, actions.back());
  while (studs < enough) {
    const float next = std::min(studs + kHarder, enough);
    Scene scene = build(next);
    const level::Level level = scene.level.compile();
    const Problem problem = support::plainProblem(level, queryFor(scene));
    float lowest = missOf(problem, actions);
    for (uint64_t tried = 0; lowest > 0 && tried < steps; tried += actions.size()) {
      Actions other = changed(actions, random);
      const float miss = missOf(problem, other);
      if (miss > lowest) continue;
      lowest = miss;
      actions = std::move(other);
    }
    if (lowest > 0) break;
    studs = next;
  }
  return studs;
}

// Returns the actions of a trajectory that a search finds, one for each tick, or an empty list.
inline Actions solutionOf(const Build& build, float studs, uint64_t steps) {
  Scene scene = build(studs);
  const level::Level level = scene.level.compile();
  const Problem problem = support::plainProblem(level, queryFor(scene));
  ThreadPool pool(availableThreads());
  solve::GoExplore search(problem, 1, {}, {pool});
  while (search.goals().empty() && search.statistics().steps < steps) search.round();
  Actions actions;
  if (search.goals().empty()) return actions;
  for (const sim::ActionRun& run : search.trajectoryTo(search.goals()[0]).actions) {
    actions.insert(actions.end(), run.ticks, run.action);
  }
  return actions;
}

// Returns the hardest solved step between `lo`, which should be solvable, and `hi`. Returns 0 if
// even `lo` is unsolved.
inline float hardestSolved(const Build& build, float lo, float hi, uint64_t steps) {
  const float enough = hi;
  Actions best = solutionOf(build, lo, steps);
  while (hi - lo > 0.2f) {
    const float middle = 0.5f * (lo + hi);
    Actions found = solutionOf(build, middle, steps);
    (found.empty() ? hi : lo) = middle;
    if (!found.empty()) best = std::move(found);
  }
  return best.empty() ? 0 : climb(build, lo, enough, best, 10 * steps);
}

}  // namespace obby::support
