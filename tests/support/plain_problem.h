// A query in plain form posed of a level: from its first spawn.
#pragma once

#include "level/level.h"
#include "sim/simulator.h"
#include "solve/model/problem.h"

namespace obby::support {

// The level must outlive it.
inline solve::Problem plainProblem(const level::Level& level, const level::QueryView& query) {
  return {level.view(),
          query,
          sim::makeWorld(level.view(), level.spawns()[0]),
          sim::startLoose(level.view()),
          level.bounds(),
          level.hasMotion()};
}

// A search that does not end: the goal is far above everything.
inline solve::Problem endlessProblem(const level::Level& level) {
  level::QueryView query;
  query.goal.region = {{{0, 500, 0}, {}}, {2, 2, 2}};
  return plainProblem(level, query);
}

}  // namespace obby::support
