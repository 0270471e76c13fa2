// Relaxations that change the level's dimensions: higher jumps, or a lower part.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solve/model/targets.h"
#include "solve/proof/boxes.h"
#include "solve/report/part_text.h"
#include "solve/report/relaxation/frontier.h"
#include "solve/report/relaxation/relaxations.h"

namespace obby::solve {

namespace {

constexpr double kHigherNotch = 0.02;  // share of the jump height
constexpr uint32_t kMaxHigher = 25;    // notches
constexpr double kLowerNotch = 0.1;    // studs
constexpr size_t kPartsToLower = 4;
constexpr float kStandsOn = 1;  // max studs between a part's top and the floor of a region on it

double jumpHeight(const Params& p) { return double(riseOfLaunch(p, p.gravity, p.jumpSpeed)); }

// Returns the launch speed of a jump of that height: the inverse of riseOfLaunch().
double launchFor(const Params& p, double height) {
  const double half = 0.5 * double(p.gravity) * double(p.substepSeconds);
  return std::sqrt(half * half + 2 * double(p.gravity) * height) - half;
}

// Returns true if the region names the part or lies on its top. `box`: bounds of the part over its
// whole motion.
bool belongsTo(schema::Region::Reader region, uint32_t part, const Box& box) {
  if (region.getPart().size() > 0) return region.getPartIndex() == int32_t(part);
  const auto at = region.getPosition();
  const Vec3 middle{at.getX(), at.getY(), at.getZ()};
  const float floor = middle.y - 0.5f * region.getSize().getY();
  const bool stands = floor >= box.lo.y && floor <= box.hi.y + kStandsOn;
  return stands && gapBetween({middle, middle}, box) == 0;
}

void sink(schema::Vec3::Builder position, double studs) {
  position.setY(float(double(position.getY()) - studs));
}

void sinkPart(schema::Part::Builder part, double studs) {
  sink(part.getPosition(), studs);
  if (!part.hasMotion()) return;
  for (auto key : part.getMotion().getKeys()) sink(key.getPosition(), studs);
}

// A goal on a platform goes down with it.
void sinkRegions(schema::Query::Builder query, uint32_t part, const Box& box, double studs) {
  const auto consider = [&](schema::Region::Builder region) {
    if (belongsTo(region.asReader(), part, box)) sink(region.getPosition(), studs);
  };
  if (query.hasGoal()) consider(query.getGoal());
  for (auto region : query.getGoals()) consider(region);
  for (auto waypoint : query.getWaypoints()) consider(waypoint.getRegion());
  for (auto region : query.getVisits()) consider(region);
  for (auto region : query.getAvoid()) consider(region);
}

Box boxOf(const level::LevelView& level, uint32_t part) {
  Box box{{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}};
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (level.colliders[i].part == part) box = join(box, level.bounds[i].box());
  }
  return box;
}

// A lower part is not always easier, since the route may lead upward from it. If the bound on reach
// reports a missing rise, it also excludes amounts that are too small, without a search.
std::vector<uint32_t> amountsToTry(const SearchOutcome& outcome) {
  if (outcome.cut && outcome.cut->missing.rise > 0) return {10, 20, 40, 80, 160};
  return {10, 20, 40, 80};
}

Change lower(const Failure& failure, uint32_t part) {
  const level::Level& level = failure.posed.level;
  Change c;
  c.kind = schema::RelaxationKind::LOWERED;
  c.part = int32_t(part);
  c.notch = kLowerNotch;
  c.scale = std::max(jumpHeight(level.view().params), 1.0);
  c.first = amountsToTry(failure.outcome);
  c.apply = [part, box = boxOf(level.view(), part)](schema::Level::Builder record,
                                                    schema::Query::Builder query, uint32_t n) {
    sinkPart(record.getParts()[part], n * kLowerNotch);
    sinkRegions(query, part, box, n * kLowerNotch);
  };
  c.text = [name = partText(failure.posed.levelRecord, part)](uint32_t n) {
    return fmt::format("solvable with {} {:.1f} studs lower", name, n * kLowerNotch);
  };
  return c;
}

}  // namespace

std::vector<Change> jumpHeightChanges(const Failure& failure) {
  const level::QueryView query = failure.posed.query.view();
  const Params& now = failure.posed.level.view().params;
  const double height = jumpHeight(now);
  if (sim::forbidsJumping(query) || query.maxJumps == 0 || !(height > 0) ||
      !std::isfinite(height)) {
    return {};
  }
  Change c;
  c.kind = schema::RelaxationKind::JUMP_HEIGHT;
  c.notch = kHigherNotch * height;
  c.scale = height;
  c.first = {kMaxHigher};
  c.apply = [now, height](schema::Level::Builder level, schema::Query::Builder, uint32_t n) {
    level.getPhysics().setJumpSpeed(float(launchFor(now, height * (1 + n * kHigherNotch))));
  };
  c.text = [height](uint32_t n) {
    return fmt::format("solvable if jumps were {:.1f} studs ({:.0f} %) higher",
                       n * kHigherNotch * height, 100 * n * kHigherNotch);
  };
  return {c};
}

std::vector<Change> loweredChanges(const Failure& failure) {
  std::vector<Change> changes;
  for (const uint32_t part : partsBeyond(failure, kPartsToLower)) {
    changes.push_back(lower(failure, part));
  }
  return changes;
}

}  // namespace obby::solve
