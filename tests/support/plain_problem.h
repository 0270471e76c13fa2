// Problems that start at a level's first spawn.
#pragma once

#include "level/level.h"
#include "sim/simulator.h"
#include "solve/model/problem.h"

namespace obby::support {

// Returns the problem of the query. The level must outlive it.
inline solve::Problem plainProblem(const level::Level& level, const level::QueryView& query) {
  return {level.view(),
          query,
          sim::makeWorld(level.view(), level.spawns()[0]),
          sim::startBodies(level.view()),
          level.bounds(),
          level.hasMotion()};
}

// Returns a problem whose search never ends: the goal is far above everything.
inline solve::Problem endlessProblem(const level::Level& level) {
  level::QueryView query;
  query.goal.region = {{{0, 500, 0}, {}}, {2, 2, 2}};
  return plainProblem(level, query);
}

}  // namespace obby::support
