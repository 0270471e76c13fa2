// A player at the start of a level, a goal region, and everything else that an observation needs.
#pragma once

#include "policy/policy.h"
#include "sim/simulator.h"

namespace obby::support {

struct Onlooker {
  explicit Onlooker(const level::Level& level, Vec3 goal = {0, 0, -30})
      : around(level.view(), policy::kSight),
        seen(around.view()),
        scene{level.view(), query, seen},
        world(sim::makeWorld(level.view(), {})) {
    query.goal.region = {{goal, {}}, {2, 2, 2}};
  }
  Onlooker(const Onlooker&) = delete;
  Onlooker& operator=(const Onlooker&) = delete;

  // Returns the inputs of this observation.
  std::vector<float> inputs(policy::Observe how, const sim::RigidBody* bodies = nullptr) const {
    std::vector<float> in(policy::kInputs);
    how(scene, world, bodies, in.data());
    return in;
  }

  policy::Surroundings around;
  policy::SurroundingsView seen;
  level::QueryView query;
  policy::Scene scene;  // refers to `query` and the surroundings above
  sim::World world;
};

}  // namespace obby::support
