// Courses of several levels for tests and benches.
#pragma once

#include <utility>
#include <vector>

#include "golden/dynamic_scenes.h"
#include "sim/batch.h"
#include "sim/simulator.h"

namespace obby::support {

// A course that owns its levels. Each level has a different time limit, after which a world moves
// on to its next level.
struct Levels {
  std::vector<level::Level> levels;
  sim::Course course;
  // Storage for the queries' pointers.
  std::vector<level::WaypointView> waypoints;
  std::vector<level::TargetView> visits, avoid, goals;
  std::vector<uint32_t> touched;

  Levels(std::vector<level::Level> owned, uint32_t timeLimitTicks) : levels(std::move(owned)) {
    level::QueryView query;
    query.goal.region = {{{0, 1, 20}, {}}, {30, 8, 4}};
    for (const level::Level& l : levels) {
      query.timeLimitTicks = timeLimitTicks + 17 * uint32_t(course.levels.size());
      course.levels.push_back(l.view());
      course.starts.push_back(sim::makeWorld(l.view(), l.spawns()[0]));
      course.queries.push_back(query);
    }
    course.restarts = true;
  }
};

// Adds rules of every kind: a waypoint around the start, a part to touch, a part not to touch, and
// limits.
inline void addRules(Levels& all) {
  all.waypoints = {{{{{{0, 2, 0}, {}}, {6, 6, 6}}}, 40, 0, {20, 90}}};
  all.touched = {0, 3};
  all.visits = {{{}, 0, 1}};
  all.avoid = {{{}, 1, 1}, {{{{0, 0, -30}, {}}, {3, 3, 3}}}};
  all.goals = {{{{{0, 2, -12}, {}}, {20, 4, 1}}}};
  for (level::QueryView& q : all.course.queries) {
    q.waypoints = all.waypoints.data();
    q.visits = all.visits.data();
    q.avoid = all.avoid.data();
    q.otherGoals = all.goals.data();
    q.touched = all.touched.data();
    q.waypointCount = q.visitCount = q.otherGoalCount = 1;
    q.avoidCount = q.touchedCount = 2;
    q.minJumps = 2;
    q.maxJumps = 7;
    q.last = {25, 300};
    q.maxDamage = 60;
    q.forbidden = 1u << uint32_t(sim::State::seated);
  }
}

// Returns a course with parts of every kind.
inline Levels everyKind() {
  std::vector<level::Level> levels;
  for (const auto& build :
       {golden::killers, golden::roles, golden::vanishing, golden::hulls, golden::clocks,
        golden::places, golden::dynamicBodies, golden::dynamicStack}) {
    levels.push_back(build().compile());
  }
  levels.push_back(golden::movers(true).compile());
  levels.push_back(boxArena(30, 3).compile());
  return Levels(std::move(levels), 107);
}

// Returns a course of box arenas with `boxes` boxes each.
inline Levels arenas(uint32_t count, uint32_t boxes, uint32_t timeLimitTicks) {
  std::vector<level::Level> levels;
  for (uint32_t i = 0; i < count; ++i) levels.push_back(boxArena(boxes, i + 1).compile());
  Levels all(std::move(levels), timeLimitTicks);
  for (level::QueryView& q : all.course.queries) q.goal.region = {{{0, 500, 0}, {}}, {2, 2, 2}};
  return all;
}

}  // namespace obby::support
