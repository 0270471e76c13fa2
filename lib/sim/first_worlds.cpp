#include "sim/first_worlds.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "sim/simulator.h"

namespace obby::sim {
namespace {

Status checkCourse(const Course& c) {
  const size_t levels = c.levels.size();
  if (levels == 0) return makeError("a batch needs at least one level");
  if (c.starts.size() != levels) {
    return makeError(fmt::format("found {} starts for {} levels, expected one for each",
                                 c.starts.size(), levels));
  }
  if (!c.queries.empty() && c.queries.size() != levels) {
    return makeError(fmt::format("found {} queries for {} levels, expected one for each",
                                 c.queries.size(), levels));
  }
  for (const World& w : c.starts) {
    if (w.outcome != Outcome::running)
      return makeError("one of the start states has already ended");
  }
  for (const uint32_t i : c.queue) {
    if (i >= levels)
      return makeError(fmt::format("the queue names level {}, but there are {} levels", i, levels));
  }
  return {};
}

void fillBodies(Course& course) {
  for (const level::LevelView& level : course.levels) {
    course.bodyStride = std::max(course.bodyStride, level.bodyCount);
  }
  course.startBodies.clear();
  for (const level::LevelView& level : course.levels) {
    std::vector<RigidBody> bodies = startBodies(level);
    bodies.resize(course.bodyStride);
    course.startBodies.insert(course.startBodies.end(), bodies.begin(), bodies.end());
  }
}

}  // namespace

Result<FirstWorlds> firstWorlds(Course& course, uint32_t count) {
  OBBY_RETURN_IF_ERROR(checkCourse(course));
  fillBodies(course);
  if (course.queue.empty()) {
    course.queue.resize(course.levels.size());
    std::iota(course.queue.begin(), course.queue.end(), 0u);
  }
  FirstWorlds first;
  for (uint32_t i = 0; i < count; ++i) {
    first.episodes.push_back({levelOf(course.set(), i, count, 0), 0});
    const uint32_t level = first.episodes.back().level;
    first.worlds.push_back(course.starts[level]);
    const auto bodies = course.startBodies.begin() + level * course.bodyStride;
    first.bodies.insert(first.bodies.end(), bodies, bodies + course.bodyStride);
  }
  return first;
}

}  // namespace obby::sim
