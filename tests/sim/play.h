// Plays a world with scripted actions, for tests of facts about the player.
#pragma once

#include <functional>
#include <vector>

#include "sim/simulator.h"
#include "support/level_builder.h"

namespace obby::test {

constexpr Turns kNorth = 0;      // -Z
constexpr Turns kEast = 0xC000;  // +X
constexpr float kTick = 1.0f / 60;

inline sim::Action walk(Turns heading, bool jump = false) { return {heading, true, jump}; }
inline sim::Action stand(bool jump = false) { return {0, false, jump}; }

struct Play {
  const level::Level& level;
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  std::vector<sim::World> history;

  uint16_t tricks = 0;  // Params::tricks

  explicit Play(const level::Level& l, Vec3 feet = {0, 0, 0}, float yaw = 0)
      : level(l),
        world(sim::makeWorld(l.view(), {feet, yaw, 0})),
        bodies(sim::makeBodies(l.view())) {
    history.push_back(world);
  }

  // Repeats an action for a number of ticks.
  Play& run(sim::Action action, int ticks = 1) {
    level::LevelView view = level.view();
    view.params.tricks = tricks;
    for (int i = 0; i < ticks; ++i) {
      sim::advance(world, bodies.data(), view, nullptr, action);
      history.push_back(world);
    }
    return *this;
  }

  // Repeats an action until the predicate holds, for at most `limit` ticks. Returns the ticks
  // taken, or -1.
  int until(sim::Action action, const std::function<bool(const sim::World&)>& done,
            int limit = 600) {
    for (int i = 0; i < limit; ++i) {
      if (done(world)) return i;
      run(action);
    }
    return done(world) ? limit : -1;
  }

  // Stands still until the state is Running.
  Play& settle() {
    until(stand(), [](const sim::World& w) { return w.state == sim::State::running; });
    return run(stand(), 10);
  }

  float highest() const {
    float y = -1e30f;
    for (const auto& w : history) y = maxf(y, w.position.y);
    return y;
  }
};

// Returns a floor for further parts. Its top is at 0.
inline support::LevelBuilder floorLevel() {
  return support::LevelBuilder().block({0, -1, 0}, {200, 2, 200});
}

inline level::Level flatLevel() {
  return support::LevelBuilder().block({0, -1, 0}, {400, 2, 400}).compile();
}

// Returns a level with only a floor. `change` sets its parameters.
template <class Change>
level::Level flatLevel(const Change& change) {
  return support::LevelBuilder().block({0, -1, 0}, {400, 2, 400}).physics(change).compile();
}

}  // namespace obby::test
