// A query that no search ends: the goal is far above everything.
#pragma once

#include "level/level.h"
#include "sim/simulator.h"
#include "solve/problem.h"

namespace obby::bench {

// The level must outlive it.
inline solve::Problem endlessProblem(const level::Level& level) {
  level::QueryView query;
  query.goal.region = {{{0, 500, 0}, {}}, {2, 2, 2}};
  return {level.view(),
          query,
          sim::makeWorld(level.view(), level.spawns()[0]),
          sim::makeLoose(level.view()),
          level.bounds(),
          level.hasMotion()};
}

}  // namespace obby::bench
