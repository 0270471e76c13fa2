#include "solve/verify/verifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/angle.h"
#include "sim/simulator.h"
#include "solve/answers/outcome_names.h"
#include "solve/verify/judge.h"

namespace obby::solve {

namespace {

Error wrong(std::string field, const std::string& recorded, const std::string& replayed) {
  return Error{{},
               {},
               std::move(field),
               fmt::format("the record says {}, the replay gives {}", recorded, replayed),
               {}};
}

Status same(const char* field, auto recorded, auto replayed) {
  if (int64_t(recorded) == int64_t(replayed)) return {};
  return wrong(field, fmt::format("{}", recorded), fmt::format("{}", replayed));
}

Status checkStart(schema::Level::Reader level, schema::Query::Reader query,
                  schema::Trajectory::Reader trajectory) {
  const auto start = query.getStart();
  Point wanted;
  float yaw = start.getYaw();
  if (start.hasRegion()) {
    wanted = BoxRegion(start.getRegion()).floor();
  } else {
    const uint32_t spawn = start.getSpawn() < 0 ? 0 : uint32_t(start.getSpawn());
    if (spawn >= level.getSpawns().size()) return wrong("position", "a start", "no such spawn");
    wanted = point(level.getSpawns()[spawn].getPosition());
    yaw = level.getSpawns()[spawn].getYaw();
  }
  const Point got = point(trajectory.getPosition());
  const double off = std::hypot(got.x - wanted.x, got.y - wanted.y, got.z - wanted.z);
  if (!(off < 1e-3)) {
    return wrong("position", fmt::format("{}, {}, {}", got.x, got.y, got.z),
                 fmt::format("a start at {}, {}, {}", wanted.x, wanted.y, wanted.z));
  }
  OBBY_RETURN_IF_ERROR(same("yawTurns", trajectory.getYawTurns(), turnsFromRadians(yaw)));
  return same("startTick", trajectory.getStartTick(), start.getTick());
}

int32_t indexIf(bool asked, uint32_t index) { return asked ? int32_t(index) : -1; }

Status checkEnd(schema::Trajectory::Reader t, const sim::World& last,
                std::span<const sim::LooseBody> loose, size_t ticks) {
  const bool avoided = last.outcome == sim::Outcome::avoided;
  OBBY_RETURN_IF_ERROR(same("ticks", t.getTicks(), ticks));
  OBBY_RETURN_IF_ERROR(same("jumps", t.getJumps(), last.jumps));
  OBBY_RETURN_IF_ERROR(same("waypoints", t.getWaypoints(), last.waypoints));
  OBBY_RETURN_IF_ERROR(same("visited", t.getVisited(), last.visited));
  OBBY_RETURN_IF_ERROR(same("part", t.getPart(), indexIf(!avoided, last.part)));
  OBBY_RETURN_IF_ERROR(same("avoid", t.getAvoid(), indexIf(avoided, last.part)));
  const uint64_t hash = sim::stateHash(last, loose);
  if (hash != t.getStateHash()) {
    return wrong("stateHash", fmt::format("{}", t.getStateHash()), fmt::format("{}", hash));
  }
  return {};
}

}  // namespace

Status verify(const level::Level& level, schema::Level::Reader levelRecord,
              schema::Query::Reader query, schema::Trajectory::Reader trajectory) {
  OBBY_RETURN_IF_ERROR(checkStart(levelRecord, query, trajectory));
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(trajectory));
  Judge judge(query, level.view());
  const sim::Replay replay = sim::replay(level.view(), nullptr, plan);
  const std::vector<sim::World>& worlds = replay.worlds;
  schema::Outcome outcome = schema::Outcome::RUNNING;
  size_t tick = 0;
  while (outcome == schema::Outcome::RUNNING && ++tick < worlds.size()) {
    const sim::World& w = worlds[tick];
    outcome = w.outcome != sim::Outcome::running
                  ? schema::Outcome(w.outcome)
                  : judge.after(tick, worlds[tick - 1], w, replay.looseAt(tick));
  }
  tick = std::min(tick, worlds.size() - 1);
  if (outcome != trajectory.getOutcome()) {
    return wrong("outcome", outcomeName(trajectory.getOutcome()),
                 fmt::format("{} at tick {}", outcomeName(outcome), tick));
  }
  sim::World last = worlds[tick];
  last.outcome = sim::Outcome(outcome);
  judge.note(last);
  return checkEnd(trajectory, last, replay.looseAt(tick), tick);
}

}  // namespace obby::solve
