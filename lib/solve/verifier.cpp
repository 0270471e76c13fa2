#include "solve/verifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/simulator.h"
#include "solve/outcome_names.h"

namespace obby::solve {

namespace {

struct Point {
  double x = 0, y = 0, z = 0;
};

Point point(schema::Vec3::Reader v) { return {v.getX(), v.getY(), v.getZ()}; }

// An oriented box, read from its record.
class BoxRegion {
 public:
  explicit BoxRegion(schema::Region::Reader region)
      : center_(point(region.getPosition())), size_(point(region.getSize())) {
    const auto q = region.getRotation();
    const double n = std::sqrt(double(q.getX()) * q.getX() + double(q.getY()) * q.getY() +
                               double(q.getZ()) * q.getZ() + double(q.getW()) * q.getW());
    const double x = q.getX() / n, y = q.getY() / n, z = q.getZ() / n, w = q.getW() / n;
    axes_[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    axes_[1] = {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
    axes_[2] = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
  }

  // Does the vertical segment of `height` studs above the feet meet the box?
  bool holds(Point feet, double height) const {
    const double half[3] = {size_.x / 2, size_.y / 2, size_.z / 2};
    double from = 0, to = height;
    for (int i = 0; i < 3; ++i) {
      const Point& a = axes_[i];
      const double o =
          a.x * (feet.x - center_.x) + a.y * (feet.y - center_.y) + a.z * (feet.z - center_.z);
      if (std::abs(a.y) < 1e-9) {
        if (std::abs(o) > half[i]) return false;
        continue;
      }
      const double t0 = (-half[i] - o) / a.y, t1 = (half[i] - o) / a.y;
      from = std::max(from, std::min(t0, t1));
      to = std::min(to, std::max(t0, t1));
    }
    return from <= to;
  }

  // Where a player who starts here has the feet.
  Point floor() const {
    const double up[3] = {std::abs(axes_[0].y), std::abs(axes_[1].y), std::abs(axes_[2].y)};
    const double drop =
        up[1] > 0.999 ? size_.y / 2 : (up[0] * size_.x + up[1] * size_.y + up[2] * size_.z) / 2;
    return {center_.x, center_.y - drop, center_.z};
  }

 private:
  Point center_, size_;
  Point axes_[3];  // of the box, in the world
};

// A query's rules, and how far a playthrough has come in them.
class Judge {
 public:
  Judge(schema::Query::Reader query, const Params& params)
      : goal_(query.getGoal()), maxJumps_(query.getMaxJumps()), height_(params.bodyTop) {
    for (const auto w : query.getWaypoints()) {
      waypoints_.emplace_back(w.getRegion());
      waypointJumps_.push_back(w.getMaxJumps());
    }
    for (const auto a : query.getAvoid()) avoid_.emplace_back(a);
    if (query.getTimeLimit() > 0) {
      ticks_ = int64_t(std::floor(double(query.getTimeLimit()) * params.controlRate + 1e-4));
    }
  }

  // After `tick` ticks the player is alive at `feet`, having jumped `jumps` times.
  schema::Outcome after(int64_t tick, Point feet, int64_t jumps) {
    for (const BoxRegion& region : avoid_) {
      if (region.holds(feet, height_)) return schema::Outcome::AVOIDED;
    }
    if (tooMany(jumps)) return schema::Outcome::JUMPS;
    while (reached_ < waypoints_.size() && waypoints_[reached_].holds(feet, height_)) {
      ++reached_;
      if (tooMany(jumps)) return schema::Outcome::JUMPS;
    }
    if (reached_ == waypoints_.size() && goal_.holds(feet, height_)) return schema::Outcome::GOAL;
    return ticks_ > 0 && tick >= ticks_ ? schema::Outcome::TIMEOUT : schema::Outcome::RUNNING;
  }

  size_t reached() const { return reached_; }

 private:
  bool tooMany(int64_t jumps) const {
    if (maxJumps_ >= 0 && jumps > maxJumps_) return true;
    return reached_ < waypoints_.size() && waypointJumps_[reached_] >= 0 &&
           jumps > waypointJumps_[reached_];
  }

  BoxRegion goal_;
  std::vector<BoxRegion> waypoints_, avoid_;
  std::vector<int32_t> waypointJumps_;
  int64_t maxJumps_;
  int64_t ticks_ = 0;  // of the time limit; 0: none
  double height_;
  size_t reached_ = 0;
};

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
  if (start.hasRegion()) {
    wanted = BoxRegion(start.getRegion()).floor();
  } else {
    const uint32_t spawn = start.getSpawn() < 0 ? 0 : uint32_t(start.getSpawn());
    if (spawn >= level.getSpawns().size()) return wrong("position", "a start", "no such spawn");
    wanted = point(level.getSpawns()[spawn].getPosition());
  }
  const Point got = point(trajectory.getPosition());
  const double off = std::hypot(got.x - wanted.x, got.y - wanted.y, got.z - wanted.z);
  if (!(off < 1e-3)) {
    return wrong("position", fmt::format("{}, {}, {}", got.x, got.y, got.z),
                 fmt::format("a start at {}, {}, {}", wanted.x, wanted.y, wanted.z));
  }
  return same("startTick", trajectory.getStartTick(), start.getTick());
}

Status checkEnd(schema::Trajectory::Reader t, const sim::World& last,
                std::span<const sim::LooseBody> loose, size_t ticks) {
  OBBY_RETURN_IF_ERROR(same("ticks", t.getTicks(), ticks));
  OBBY_RETURN_IF_ERROR(same("jumps", t.getJumps(), last.jumps));
  OBBY_RETURN_IF_ERROR(same("waypoints", t.getWaypoints(), last.waypoints));
  OBBY_RETURN_IF_ERROR(same("part", t.getPart(), int32_t(last.part)));
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
  Judge judge(query, level.view().params);
  const sim::Replay replay = sim::replay(level.view(), nullptr, plan);
  const std::vector<sim::World>& worlds = replay.worlds;
  schema::Outcome outcome = schema::Outcome::RUNNING;
  size_t tick = 0;
  while (outcome == schema::Outcome::RUNNING && ++tick < worlds.size()) {
    const sim::World& w = worlds[tick];
    outcome = w.outcome != sim::Outcome::running
                  ? schema::Outcome(w.outcome)
                  : judge.after(int64_t(tick), {w.position.x, w.position.y, w.position.z}, w.jumps);
  }
  tick = std::min(tick, worlds.size() - 1);
  if (outcome != trajectory.getOutcome()) {
    return wrong("outcome", outcomeName(trajectory.getOutcome()),
                 fmt::format("{} at tick {}", outcomeName(outcome), tick));
  }
  sim::World last = worlds[tick];
  last.outcome = sim::Outcome(outcome);
  last.waypoints = uint8_t(judge.reached());
  return checkEnd(trajectory, last, replay.looseAt(tick), tick);
}

}  // namespace obby::solve
