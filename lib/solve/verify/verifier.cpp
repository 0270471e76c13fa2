#include "solve/verify/verifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "level/tricks.h"
#include "math/angle.h"
#include "sim/simulator.h"
#include "solve/model/outcome_names.h"
#include "solve/verify/judge.h"

namespace obby::solve {

namespace {

Error wrong(std::string field, const std::string& recorded, const std::string& replayed) {
  return Error{{},
               {},
               std::move(field),
               fmt::format("the record says {}, but the replay gives {}", recorded, replayed),
               {}};
}

Status same(const char* field, auto recorded, auto replayed) {
  if (int64_t(recorded) == int64_t(replayed)) return {};
  return wrong(field, fmt::format("{}", recorded), fmt::format("{}", replayed));
}

// Returns an error if the recorded place is not that of the replay, within 0.001 studs.
Status samePlace(std::string field, Point recorded, Point replayed) {
  const double x = recorded.x - replayed.x, y = recorded.y - replayed.y;
  if (std::hypot(x, y, recorded.z - replayed.z) < 1e-3) return {};
  const auto text = [](Point p) { return fmt::format("{}, {}, {}", p.x, p.y, p.z); };
  return wrong(std::move(field), text(recorded), text(replayed));
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
    if (spawn >= level.getSpawns().size()) {
      return Error{
          {}, {}, "position", fmt::format("the level has no spawn {} to start on", spawn), {}};
    }
    wanted = point(level.getSpawns()[spawn].getPosition());
    yaw = level.getSpawns()[spawn].getYaw();
  }
  OBBY_RETURN_IF_ERROR(samePlace("position", point(trajectory.getPosition()), wanted));
  OBBY_RETURN_IF_ERROR(same("yawTurns", trajectory.getYawTurns(), turnsFromRadians(yaw)));
  return same("startTick", trajectory.getStartTick(), start.getTick());
}

// Returns an error if the plan uses tricks that the query does not allow.
Status checkTricks(schema::Query::Reader query, const sim::Plan& plan) {
  OBBY_ASSIGN(const uint16_t allowed, level::tricksOf(query.getTricks(), "tricks"));
  if ((plan.tricks & ~allowed) == 0) return {};
  return Error{{}, {}, "tricks", "the record uses a trick that the query does not allow", {}};
}

// Returns an error if the plan leaves the keyboard's eight directions and the query allows no
// others.
Status checkDirections(schema::Query::Reader query, const sim::Plan& plan) {
  if (query.getDirections() == schema::Directions::ANY) return {};
  constexpr int32_t kEighth = 65536 / 8;
  for (size_t i = 0; i < plan.actions.size(); ++i) {
    const sim::Action& action = plan.actions[i].action;
    if (!action.walk || (int32_t(action.heading) - int32_t(plan.yaw)) % kEighth == 0) continue;
    return Error{{},
                 {},
                 fmt::format("actions[{}].heading", i),
                 "the heading is not one of the keyboard's eight directions",
                 {}};
  }
  return {};
}

int32_t indexIf(bool asked, uint32_t index) { return asked ? int32_t(index) : -1; }

Status checkEnd(schema::Trajectory::Reader t, const sim::ReplayEnd& end) {
  const sim::World& last = end.world;
  const bool avoided = last.outcome == sim::Outcome::avoided;
  OBBY_RETURN_IF_ERROR(same("ticks", t.getTicks(), end.ticks));
  OBBY_RETURN_IF_ERROR(same("jumps", t.getJumps(), last.jumps));
  OBBY_RETURN_IF_ERROR(same("waypoints", t.getWaypoints(), last.waypoints));
  OBBY_RETURN_IF_ERROR(same("visited", t.getVisited(), last.visited));
  OBBY_RETURN_IF_ERROR(same("part", t.getPart(), indexIf(!avoided, last.part)));
  OBBY_RETURN_IF_ERROR(same("avoid", t.getAvoid(), indexIf(avoided, last.part)));
  const uint64_t hash = sim::stateHash(last, end.bodies);
  if (hash != t.getStateHash()) {
    return wrong("stateHash", fmt::format("{}", t.getStateHash()), fmt::format("{}", hash));
  }
  if (!t.hasEndPosition()) return {};
  return samePlace("endPosition", point(t.getEndPosition()), feetOf(last));
}

// The player's positions along the trajectory, to check the record's path.
struct Walked {
  std::vector<Point> feet;          // (ticks + 1), the start first
  std::vector<uint32_t> jumpTicks;  // ticks at which a jump was made

  void add(const sim::Moment& now) {
    feet.push_back(feetOf(now.world));
    if (now.world.jumps > now.before.jumps) jumpTicks.push_back(now.tick);
  }
};

Status checkPath(schema::Path::Reader path, const Walked& walked) {
  const size_t step = path.getStep(), ticks = walked.feet.size() - 1;
  if (step == 0) return Error{{}, {}, "path.step", "expected at least 1 tick, found 0", {}};
  const auto points = path.getPoints();
  if (path.getTicks() != 0) OBBY_RETURN_IF_ERROR(same("path.ticks", path.getTicks(), ticks));
  // Earlier versions wrote neither the last point of a path nor its tick.
  const bool endless = path.getTicks() == 0 && points.size() == ticks / step + 1;
  if (!endless) {
    OBBY_RETURN_IF_ERROR(same("path.points", points.size(), (ticks + step - 1) / step + 1));
  }
  for (uint32_t i = 0; i < points.size(); ++i) {
    OBBY_RETURN_IF_ERROR(samePlace(fmt::format("path.points[{}]", i), point(points[i]),
                                   walked.feet[std::min(i * step, ticks)]));
  }
  const std::vector<uint32_t>& jumps = walked.jumpTicks;
  const auto recorded = path.getJumpTicks();
  OBBY_RETURN_IF_ERROR(same("path.jumpTicks", recorded.size(), jumps.size()));
  for (uint32_t i = 0; i < recorded.size(); ++i) {
    OBBY_RETURN_IF_ERROR(same(fmt::format("path.jumpTicks[{}]", i).c_str(), recorded[i], jumps[i]));
  }
  return {};
}

}  // namespace

Status verify(const level::Level& level, schema::Level::Reader levelRecord,
              schema::Query::Reader query, schema::Trajectory::Reader trajectory) {
  OBBY_RETURN_IF_ERROR(checkStart(levelRecord, query, trajectory));
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(trajectory));
  OBBY_RETURN_IF_ERROR(checkTricks(query, plan));
  OBBY_RETURN_IF_ERROR(checkDirections(query, plan));
  Judge judge(query, level.view());
  schema::Outcome outcome = schema::Outcome::RUNNING;
  Walked walked;
  const auto look = [&](const sim::Moment& now) {
    if (trajectory.hasPath()) walked.add(now);
    if (now.world.outcome != sim::Outcome::running) {
      outcome = schema::Outcome(now.world.outcome);
    } else if (now.tick > 0) {
      outcome = judge.after(now);
    }
    return outcome == schema::Outcome::RUNNING;
  };
  sim::ReplayEnd end = sim::replay(level.view(), nullptr, plan, look);
  if (outcome != trajectory.getOutcome()) {
    return wrong("outcome", outcomeName(trajectory.getOutcome()),
                 fmt::format("{} at tick {}", outcomeName(outcome), end.ticks));
  }
  end.world.outcome = sim::Outcome(outcome);
  judge.note(end.world);
  OBBY_RETURN_IF_ERROR(checkEnd(trajectory, end));
  return trajectory.hasPath() ? checkPath(trajectory.getPath(), walked) : Status();
}

}  // namespace obby::solve
