// Trajectories that tests make by choosing keys from the player's state.
#pragma once

#include <functional>

#include "scenes.h"
#include "solve/model/route.h"

namespace obby::solve {

// Plays until the end of the trajectory, for at most `max` ticks.
inline Trajectory playByHand(const Problem& problem,
                             const std::function<sim::Action(const sim::World&)>& keys,
                             uint32_t max = 1500) {
  Trajectory p;
  p.end = problem.start;
  p.endBodies = problem.startBodies;
  while (p.end.outcome == sim::Outcome::running && p.ticks < max) {
    p.actions.push_back({keys(p.end), 1});
    sim::advance(p.end, p.endBodies.data(), problem.level, &problem.query, p.actions.back().action);
    ++p.ticks;
  }
  return p;
}

// Walks along -Z, and presses jump while the feet are between two positions.
inline std::function<sim::Action(const sim::World&)> walkAndJump(float from, float to) {
  return [=](const sim::World& w) {
    return sim::Action{0, true, w.position.z <= from && w.position.z > to};
  };
}

// A platform from z = 0 to -8, a gap, and another platform of the same size. The tops are at height
// 0, and the goal is above the far half of the second platform.
struct GapScene {
  explicit GapScene(float gap, float width = 8)
      : level(build(gap, width).compile()), asked(level), problem(asked.problem()) {
    problem.query.goal = boxAt({0, 2, -14 - gap}, {width, 4, 4});
  }
  static LevelBuilder build(float gap, float width) {
    LevelBuilder b;
    b.block({0, -0.5f, -4}, {8, 1, 8}).block({0, -0.5f, -12 - gap}, {width, 1, 8});
    b.spawn({0, 0, -2});
    b.physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-40); });
    return b;
  }
  // Presses jump for one tick, at the first tick beyond `z`.
  Course jumpAt(float z) const {
    return courseOf(problem, playByHand(problem, walkAndJump(z, z - 0.26f)));
  }
  level::Level level;
  PlainQuery asked;
  Problem problem;
};

}  // namespace obby::solve
