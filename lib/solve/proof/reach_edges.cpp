// How far parts put out who passes them, without slowing them down: a body that falls past an edge
// is in the part by no more than it has fallen in a substep, and is put out aside where that is the
// shorter way.
#include <algorithm>
#include <utility>
#include <vector>

#include "solve/proof/body_reach.h"
#include "solve/proof/reach_bound.h"
#include "solve/proof/solids.h"

namespace obby::solve {

namespace {

// Is it a block that stands still and has all of `place` above or below itself? It puts nobody out
// toward that.
bool isAround(const level::LevelView& level, uint32_t id, const Box& place) {
  constexpr float kRounding = 1e-3f;  // studs
  if (!isStill(level, id)) return false;
  const level::Collider& c = level.colliders[id];
  for (int corner = 0; corner < 4; ++corner) {
    const Vec3 at{(corner & 1) != 0 ? place.hi.x : place.lo.x, c.pose.position.y,
                  (corner & 2) != 0 ? place.hi.z : place.lo.z};
    const Vec3 local = abs(toLocal(c.pose, at));
    if (local.x > c.shape.half.x + kRounding || local.z > c.shape.half.z + kRounding) return false;
  }
  return true;
}

// Is it a block that is always there, and that nobody whose feet are between those heights passes
// over or under?
bool isWall(const level::LevelView& level, uint32_t id, float lowest, float highest) {
  constexpr uint32_t kComesAndGoes = level::kVanishTimer | level::kClocked | level::kOneWay;
  const level::Bounds& bounds = level.bounds[id];
  if (!isStill(level, id) || (bounds.flags & kComesAndGoes) != 0) return false;
  const Box box = bounds.box();
  return box.hi.y > highest + level.params.headBottom && box.lo.y < lowest + level.params.bodyTop;
}

// In the frame of the part.
Box seenFrom(const level::Collider& c, const Box& box) {
  const Vec3 half = (box.hi - box.lo) * 0.5f, at = toLocal(c.pose, box.lo + half);
  const Mat3& r = c.pose.rotation;
  const Vec3 extent{dot(abs(r.x), half), dot(abs(r.y), half), dot(abs(r.z), half)};
  return {at - extent, at + extent};
}

// Some numbers along an axis of a block, from its middle.
struct Span {
  float lo, hi;
};

// From one place to another on the far side of a block, seen from above: past one of its ends. 0:
// they are not on either side of it. `half`: of the block; `aside`: across, to its ends.
float pastEnd(Span a, Span b, float half, Span aAcross, Span bAcross, float aside) {
  const bool across = (a.lo >= half && b.hi <= -half) || (b.lo >= half && a.hi <= -half);
  if (!across) return 0;
  const float high = std::max(aside - aAcross.hi, 0.0f) + std::max(aside - bAcross.hi, 0.0f);
  const float low = std::max(aside + aAcross.lo, 0.0f) + std::max(aside + bAcross.lo, 0.0f);
  return length(Vec3{std::max(a.lo - b.hi, b.lo - a.hi), 0, std::min(low, high)});
}

// Studs from one box to the other around a block that stands upright; 0: it is not across the way.
float wayAround(const level::Collider& c, const Box& from, const Box& to) {
  const Box a = seenFrom(c, from), b = seenFrom(c, to);
  const Span ax{a.lo.x, a.hi.x}, az{a.lo.z, a.hi.z}, bx{b.lo.x, b.hi.x}, bz{b.lo.z, b.hi.z};
  const Vec3 half = c.shape.half;
  return std::max(pastEnd(ax, bx, half.x, az, bz, half.z), pastEnd(az, bz, half.z, ax, bx, half.x));
}

// Studs more than `speed` takes anybody that somebody gains who turns with the narrow side of the
// body at a part. A tick's turn is less than a walk, but for the first substep.
float turnedAway(const Params& p, float speed, bool carried) {
  const float corner = 0.5f * length(Vec3{p.bodyWidth, 0, p.bodyDepth});
  const float turned = p.turnSpeed * p.tickSeconds * corner, walked = speed * p.substepSeconds;
  const bool slower = turned + walked <= speed * p.tickSeconds;
  if (slower && !carried) return std::max(turned - walked, 0.0f);
  return corner - 0.5f * std::min(p.bodyWidth, p.bodyDepth);
}

}  // namespace

ReachBound::Heights ReachBound::heights() const {
  Heights h{problem_.start.position.y, 0, 0, 0};
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    const Launch l = launch(supports_[i]);
    h.apex = std::max(h.apex, flight_.apex(l));
    h.upward = std::max(h.upward, l.upward);
  }
  riseOnSpring(p_, [&](float, float up) { h.upward = std::max(h.upward, up); });
  // Parts that turn and carry turn the player too.
  const uint32_t any = flagsOfAll(problem_.level);
  h.beside = turnedAway(p_, flight_.sideways(), (any & level::kCarries) != 0);
  h.climbed = fastestClimb(problem_.level) * p_.substepSeconds;
  return h;
}

// How far the part puts out who passes it, at most. No push is farther than what led into the part
// in that substep, or, of a part that moves up or down, tick; who is to be put out again has to
// come back first.
float ReachBound::putOutPast(const Support& s, const Heights& of) const {
  constexpr float kSafe = 0.45f;  // of a body: substeps are cut up where bodies would go farther
  const level::Bounds& bounds = problem_.level.bounds[s.collider];
  const Box box = bounds.box();
  if (box.lo.y > of.apex + p_.bodyTop || box.hi.y < lowest_) return 0;  // nobody touches it
  const float usual = flight_.sideways();
  const auto fallTo = [&](float feet) {
    const float speed = sqrtf32(2 * p_.gravity * std::max(of.apex - feet, 0.0f));
    return std::min(std::max(speed, of.upward), p_.maxFallSpeed);
  };
  float studs = of.beside + 2 * usual * p_.substepSeconds;  // at two corners
  const bool still = isStill(problem_.level, s.collider);
  const float top = lowestTop(box, still), underside = highestUnderside(box, still);
  // Else nobody comes over it, nor under it.
  if (top <= of.apex + p_.headBottom || underside >= lowest_ + p_.bodyTop) {
    const float step = fallTo(top - p_.hipHeight - 1) * p_.substepSeconds;
    const float most = kSafe * std::min(p_.bodyWidth, p_.bodyDepth);
    const float cut = std::min(step, std::max(most, step / float(sim::kMostSplits)));
    studs += std::max(cut, of.climbed);
    studs += s.upward * p_.tickSeconds;
  }
  if (bounds.flags & level::kOneWay) studs += p_.oneWaySlack;
  if (!s.tilted) return studs;
  // A slope turns a fall aside, until keys have slowed that down.
  const Glance glance = glanceAt(speedAfter(usual, fallTo(s.entry), true), 0);
  const float gained = std::max(glance.after - usual, 0.0f);
  return studs + glance.atOnce + gained * gained / (2 * std::max(p_.airAccel, 1e-3f));
}

// What is far from the straight way, or a wall across it, costs more than it gains: whoever passes
// some of them has come as far as past the one that takes farthest.
float ReachBound::wayPast(const Box& from, const std::vector<Ride>& rides, const Box& to) const {
  const float straight = wayBetween(from, rides, to);
  const Heights of = heights();
  // Below all that carries nobody comes up again.
  const float lowest = std::min(lowest_, to.lo.y - p_.bodyTop);
  std::vector<std::pair<float, float>> passed;  // studs of a way by it; that it puts out by
  for (const Support& s : supports_) {
    if (s.collider == level::kNone || !isSolid(problem_.level, s.collider)) continue;
    if (isAround(problem_.level, s.collider, to)) continue;
    float way = gapBetween(from, s.feet) + gapBetween(s.feet, to);
    if (isWall(problem_.level, s.collider, lowest, of.apex)) {
      way = std::max(way, wayAround(problem_.level.colliders[s.collider], from, to));
    }
    passed.emplace_back(rides.empty() ? std::max(way, straight) : straight, putOutPast(s, of));
  }
  std::sort(passed.begin(), passed.end());
  float least = straight, gained = 0;
  for (const auto& [way, studs] : passed) {
    gained += studs;
    least = std::min(least, way - gained);
  }
  return std::max(least, 0.0f);
}

}  // namespace obby::solve
