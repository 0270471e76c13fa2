// Code shared by CPU batches and kernel batches.
#include "sim/batch.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "sim/simulator.h"

namespace obby::sim {
namespace {

Status checkPlans(const Actions& a, uint32_t worlds) {
  if (a.firsts.size() != size_t(worlds) + 1) {
    return makeError(fmt::format("'firsts' has {} entries for {} worlds", a.firsts.size(), worlds),
                     "give it one entry for each world, and one more");
  }
  for (size_t i = 0; i + 1 < a.firsts.size(); ++i) {
    if (a.firsts[i] > a.firsts[i + 1])
      return makeError(fmt::format("plan {} ends before it starts", i));
  }
  if (a.firsts.back() <= a.runs.size()) return {};
  return makeError(
      fmt::format("expected {} runs for these plans, found {}", a.firsts.back(), a.runs.size()));
}

Status checkActions(const Actions& a, uint32_t ticks, uint32_t worlds) {
  if (a.kind == ActionKind::plans) return checkPlans(a, worlds);
  if (a.kind == ActionKind::walker || a.table.size() == size_t(ticks) * worlds) return {};
  return makeError(
      fmt::format("expected an action for each of {} ticks in each of {} worlds, found {}", ticks,
                  worlds, a.table.size()));
}

}  // namespace

LevelSet Course::set() const {
  return {levels.data(),
          queries.empty() ? nullptr : queries.data(),
          starts.data(),
          startBodies.data(),
          queue.data(),
          uint32_t(levels.size()),
          uint32_t(queue.size()),
          bodyStride,
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
  OBBY_ASSIGN(const std::vector<RigidBody> states, bodies());
  for (size_t i = 0; i < all.size(); ++i) {
    const std::span<const RigidBody> own(states.data() + i * bodyStride_, bodyStride_);
    const uint64_t state = stateHash(all[i], own);
    h = hashBytes(&state, sizeof state, h);
  }
  return h;
}

}  // namespace obby::sim
