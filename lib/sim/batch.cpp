// Code that batches on every machine share.
#include "sim/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "base/hash.h"
#include "sim/first_worlds.h"
#include "sim/simulator.h"

namespace obby::sim {
namespace {

Status checkPlans(const Actions& a, uint32_t worlds) {
  if (a.firsts.size() != size_t(worlds) + 1) {
    return makeError(fmt::format("{} plans for {} worlds", a.firsts.size(), worlds),
                     "give firsts one entry for each world and one more");
  }
  for (size_t i = 0; i + 1 < a.firsts.size(); ++i) {
    if (a.firsts[i] > a.firsts[i + 1])
      return makeError(fmt::format("plan {} ends before it begins", i));
  }
  if (a.firsts.back() <= a.runs.size()) return {};
  return makeError(
      fmt::format("expected {} runs for these plans, found {}", a.firsts.back(), a.runs.size()));
}

Status checkActions(const Actions& a, uint32_t ticks, uint32_t worlds) {
  if (a.kind == ActionKind::plans) return checkPlans(a, worlds);
  if (a.kind == ActionKind::walker || a.table.size() == size_t(ticks) * worlds) return {};
  return makeError(fmt::format("expected actions for {} ticks of {} worlds, found {}", ticks,
                               worlds, a.table.size()));
}

Status checkCourse(const Course& c) {
  const size_t levels = c.levels.size();
  if (levels == 0) return makeError("a batch needs at least one level");
  if (c.starts.size() != levels) {
    return makeError(fmt::format("{} starts for {} levels", c.starts.size(), levels));
  }
  if (!c.queries.empty() && c.queries.size() != levels) {
    return makeError(fmt::format("{} queries for {} levels", c.queries.size(), levels));
  }
  for (const World& w : c.starts) {
    if (w.outcome != Outcome::running)
      return makeError("a start must be a state in which play goes on");
  }
  for (const uint32_t i : c.queue) {
    if (i >= levels)
      return makeError(fmt::format("the queue names level {}, but there are {} levels", i, levels));
  }
  return {};
}

}  // namespace

LevelSet Course::set() const {
  return {levels.data(),
          queries.empty() ? nullptr : queries.data(),
          starts.data(),
          startLoose.data(),
          queue.data(),
          uint32_t(levels.size()),
          uint32_t(queue.size()),
          looseStride,
          restarts};
}

Course courseOf(const level::LevelView& level, const level::StartPose& start) {
  Course course;
  course.levels = {level};
  course.starts = {makeWorld(level, start)};
  return course;
}

Status Batch::step(uint32_t ticks, const Actions& actions) {
  OBBY_RETURN_IF_ERROR(checkActions(actions, ticks, size_));
  return run(ticks, actions);
}

Result<uint64_t> Batch::hash() const {
  OBBY_ASSIGN(const std::vector<World> all, worlds());
  uint64_t h = 0;
  OBBY_ASSIGN(const std::vector<LooseBody> bodies, loose());
  for (size_t i = 0; i < all.size(); ++i) {
    const std::span<const LooseBody> own(bodies.data() + i * looseStride_, looseStride_);
    const uint64_t state = stateHash(all[i], own);
    h = hashBytes(&state, sizeof state, h);
  }
  return h;
}

namespace {

void fillLoose(Course& course) {
  for (const level::LevelView& level : course.levels) {
    course.looseStride = std::max(course.looseStride, level.looseCount);
  }
  course.startLoose.clear();
  for (const level::LevelView& level : course.levels) {
    std::vector<LooseBody> bodies = startLoose(level);
    bodies.resize(course.looseStride);
    course.startLoose.insert(course.startLoose.end(), bodies.begin(), bodies.end());
  }
}

}  // namespace

Result<FirstWorlds> firstWorlds(Course& course, uint32_t count) {
  OBBY_RETURN_IF_ERROR(checkCourse(course));
  fillLoose(course);
  if (course.queue.empty()) {
    course.queue.resize(course.levels.size());
    std::iota(course.queue.begin(), course.queue.end(), 0u);
  }
  FirstWorlds first;
  for (uint32_t i = 0; i < count; ++i) {
    first.episodes.push_back({levelOf(course.set(), i, count, 0), 0});
    const uint32_t level = first.episodes.back().level;
    first.worlds.push_back(course.starts[level]);
    const auto bodies = course.startLoose.begin() + level * course.looseStride;
    first.loose.insert(first.loose.end(), bodies, bodies + course.looseStride);
  }
  return first;
}

}  // namespace obby::sim
