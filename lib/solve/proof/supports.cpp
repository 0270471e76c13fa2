#include "solve/proof/supports.h"

#include <algorithm>

#include "solve/proof/body_reach.h"

namespace obby::solve {

namespace {

constexpr float kSnap = 1;        // studs a tick: movers that jump further push through things
constexpr float kSteepSpeed = 4;  // studs/s gained on faces steeper than any slope limit
constexpr uint32_t kLeads = level::kPad | level::kTeleport | level::kSeat;  // on touch
constexpr float kMostVertical = 1e-3f;
constexpr float kLeastSlope = 80;  // degrees: below, sliding down makes speeds without a bound

// What a mover does to those around it.
struct Motion {
  float upward = 0, sideways = 0;  // fastest of any of its points, studs/s
  float lowestTop = 0;             // of an upright block: its top at its lowest
  Box swept;
  bool rough = false;  // turns over, rises, or jumps: may push a player through other parts
};

void noteStep(Motion& m, Vec3 step, float turned, float rate) {
  const float side = length(Vec3{step.x, 0, step.z}) + turned;
  m.upward = std::max(m.upward, (absf(step.y) + turned) * rate);
  m.sideways = std::max(m.sideways, side * rate);
  m.rough |= side > kSnap || absf(step.y) > kMostVertical;
}

// Bound on how far a tick of spin moves a point at `radius`.
float spinStep(const Mat3& a, const Mat3& b, float radius) {
  const Vec3 x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return radius * sqrtf32(dot(x, x) + dot(y, y) + dot(z, z));
}

// Once its clock has run out a mover is back at its beginning, wherever it was, in one tick.
void noteReturn(Motion& motion, const level::Mover& m, float radius, float rate, bool carries) {
  if (m.trigger == level::kNone) return;
  Motion back;
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    const Vec3 step = m.keys[0].position - m.keys[k].position;
    noteStep(back, step, spinStep(m.keys[k].rotation, m.keys[0].rotation, radius), rate);
  }
  for (uint32_t k = 0; k < m.spinCount; ++k) {
    const float turned = spinStep(m.spins[k], m.spins[0], radius);
    noteStep(back, {}, turned, rate);
  }
  motion.rough |= back.rough;
  if (!carries) return;
  motion.upward = std::max(motion.upward, back.upward);
  motion.sideways = std::max(motion.sideways, back.sideways);
}

Motion motionOf(const level::LevelView& level, uint32_t collider) {
  const level::Collider& c = level.colliders[collider];
  const level::Mover& m = level.movers[c.mover];
  const bool upright = (level.bounds[collider].flags & level::kUpright) != 0;
  // Who sits on what turns over may be farther from its centre than its corners are.
  const bool swings = !upright && (level.bounds[collider].flags & level::kSeat) != 0;
  const float half = std::max(length(c.shape.half), swings ? level.params.seatHeight : 0.0f);
  const float own = half + length(m.pivot), rate = level.params.controlRate;
  const float radius = own + feetAway(level.params, level.bounds[collider].flags);
  Motion motion;
  motion.swept = level.bounds[collider].box();
  motion.rough = !upright;
  motion.lowestTop = 1e30f;
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    motion.lowestTop = std::min(motion.lowestTop, m.keys[k].position.y + c.shape.half.y);
    if (k + 1 == m.keyCount && m.once) break;
    const Pose &from = m.keys[k], &to = m.keys[(k + 1) % m.keyCount];
    noteStep(motion, to.position - from.position, spinStep(from.rotation, to.rotation, radius),
             rate);
  }
  float spin = 0;
  for (uint32_t k = 0; k < m.spinCount; ++k) {
    spin = std::max(spin, spinStep(m.spins[k], m.spins[(k + 1) % m.spinCount], radius));
  }
  motion.sideways += spin * rate;
  if (!upright) motion.upward += spin * rate;
  motion.rough |= spin > kSnap;
  const bool carries = (level.bounds[collider].flags & (level::kCarries | level::kSeat)) != 0;
  noteReturn(motion, m, radius, rate, carries);
  return motion;
}

class Builder {
 public:
  explicit Builder(const Problem& problem)
      : problem_(problem), level_(problem.level), p_(level_.params), rise_(springRise(p_)) {}

  std::vector<Support> build() {
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      if (level_.colliders[i].mover != level::kNone) movers_.push_back(motionOf(level_, i));
    }
    addPoint(problem_.start.position);
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      if (!(level_.bounds[i].flags & level::kTeleport)) continue;
      gates_.push_back(addPoint(level_.roles[level_.colliders[i].role].teleportTo));
    }
    for (uint32_t i = 0; i < level_.colliderCount; ++i) add(i);
    throwOutOfGates();
    return std::move(supports_);
  }

 private:
  // Some teleporters leave the player the speed that anything may have given.
  void throwOutOfGates() {
    const float jump = fastestJump(level_);
    float fastest = 0;
    for (const Support& s : supports_) fastest = std::max({fastest, s.thrown, s.upward + jump});
    for (const Support& s : supports_) {
      if (s.leadsTo == level::kNone) continue;
      const level::Roles& r = level_.roles[level_.colliders[s.collider].role];
      if (!r.teleportKeepsVelocity) continue;
      supports_[s.leadsTo].thrown = fastest;
      supports_[s.leadsTo].keepsSpeed = true;
    }
  }

  // Where a player appears: nothing carries there.
  uint32_t addPoint(Vec3 feet) {
    Support s;
    s.feet = grow(Box{feet, feet}, {kSlack, kSlack, kSlack});
    s.entry = 1e30f;
    s.top = feet.y;
    supports_.push_back(s);
    return uint32_t(supports_.size()) - 1;
  }

  // Could the body be inside of it without having come in from the side or top?
  bool canHoldBody(const Box& part, uint32_t flags) const {
    if (flags & (level::kVanishTimer | level::kClocked)) return true;
    const Vec3 body{p_.bodyWidth, p_.bodyTop + kSlack, p_.bodyWidth};
    for (const Support& s : supports_) {
      // Above the floor that the feet may stand on.
      const Box there{s.feet.lo + Vec3{-body.x, 2 * kSlack, -body.z}, s.feet.hi + body};
      if (s.collider == level::kNone && overlaps(part, there)) return true;
    }
    const Box around = grow(part, body);
    return std::any_of(movers_.begin(), movers_.end(),
                       [&](const Motion& m) { return m.rough && overlaps(around, m.swept); });
  }

  void add(uint32_t id) {
    const level::Collider& c = level_.colliders[id];
    const level::Bounds& bounds = level_.bounds[id];
    const Motion still{}, *motion = &still;
    if (c.mover != level::kNone) motion = &movers_[moverAt_++];
    if (!(bounds.flags & (level::kSolid | kLeads))) return;
    Support s;
    s.collider = id;
    const Box box = bounds.box();
    s.carries = (bounds.flags & (level::kSolid | level::kSeat)) != 0;
    s.top = box.hi.y;
    const float side = sideOf(bounds.flags);
    s.feet = grow(box, {side, 0, side});
    s.feet.hi.y += s.carries ? rise_ : touchSlack(p_);
    if (bounds.flags & level::kSeat) s.feet = join(s.feet, seatedIn(box));
    const bool holds = canHoldBody(box, bounds.flags);
    s.entry = holds ? besideOf(box)
                    : entryOf(box, bounds.flags, c.mover != level::kNone ? motion : nullptr);
    s.snaps = holds || (bounds.flags & (level::kSeat | level::kTeleport)) != 0;
    s.upward = motion->upward;
    s.pushes = motion->sideways;
    if (bounds.flags & (level::kCarries | level::kSeat)) s.sideways = motion->sideways;
    addSurface(s, c, bounds.flags);
    if (bounds.flags & level::kTeleport) s.leadsTo = gates_[gateAt_++];
    supports_.push_back(s);
  }

  // How far from the part's box its player can be, seen from above: body, limbs or climb sensor.
  float sideOf(uint32_t flags) const {
    float side = bodySide(p_) + kSlack;
    if (flags & level::kTruss) side += p_.climbReach;
    return flags & kLeads ? std::max(side, limbSide(p_) + touchSlack(p_)) : side;
  }

  // Feet of those who sit: the root is above the seat's centre, wherever the seat has its top.
  Box seatedIn(const Box& seat) const {
    const float away = p_.seatHeight + kSlack, root = p_.hipHeight + 0.5f * p_.rootHeight;
    return {seat.lo - Vec3{away, away + root, away}, seat.hi + Vec3{away, away - root, away}};
  }

  // From any side, at any height.
  float besideOf(const Box& box) const { return box.lo.y - p_.bodyTop - kSlack - touchSlack(p_); }

  float entryOf(const Box& box, uint32_t flags, const Motion* motion) const {
    if (flags & (level::kTruss | kLeads)) return besideOf(box);
    // Rays see a floor from here on, and push-out lifts a torso that is not deeper in it.
    const float legs = std::max(sim::rayHeight(p_), p_.hipHeight) + 0.5f * p_.bodyDepth + kSlack;
    if (!(flags & level::kUpright)) return box.lo.y - legs;
    return (motion != nullptr ? motion->lowestTop : box.hi.y) - legs;
  }

  void addSurface(Support& s, const level::Collider& c, uint32_t flags) const {
    if (flags & level::kConveyor) {
      const level::Roles& r = level_.roles[c.role];
      const Box around = grow(s.feet, {0, p_.bodyTop, 0});
      const Vec3 far = max(abs(around.lo - r.conveyorCenter), abs(around.hi - r.conveyorCenter));
      const float turning = length(r.conveyorAngular) * length(far);
      s.sideways += length(Vec3{r.conveyorVelocity.x, 0, r.conveyorVelocity.z}) + turning;
      s.upward += absf(r.conveyorVelocity.y) + turning;
    }
    if (flags & level::kPad) {
      const Vec3 v = level_.roles[c.role].padVelocity;
      s.thrown = std::max(s.thrown, v.y);
      s.sideways = std::max(s.sideways, length(Vec3{v.x, 0, v.z}));
    }
    if (flags & level::kTruss) {
      s.thrown = std::max(s.thrown, s.upward + p_.climbSpeed * fastestWalk(level_));
    }
    s.tilted = !(flags & level::kUpright) && s.carries;
    if (s.tilted) s.sideways = std::max(s.sideways, kSteepSpeed);
  }

  const Problem& problem_;
  const level::LevelView& level_;
  const Params& p_;
  const float rise_;
  std::vector<Motion> movers_;   // of the colliders that move, in their order
  std::vector<uint32_t> gates_;  // where teleporters lead, in their order
  size_t moverAt_ = 0, gateAt_ = 0;
  std::vector<Support> supports_;
};

}  // namespace

std::vector<Support> supportsOf(const Problem& problem) { return Builder(problem).build(); }

const char* unboundedPart(const level::LevelView& level) {
  if (level.looseCount != 0) return "loose parts, which can be pushed anywhere";
  if (!(level.params.gravity > 1)) return "next to no gravity";
  if (level.params.maxSlope < kLeastSlope * kPi / 180) return "slopes to slide down";
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (!(level.bounds[i].flags & level::kPad)) continue;
    const level::Roles& r = level.roles[level.colliders[i].role];
    const bool slanted = r.padVelocity.x != 0 || r.padVelocity.z != 0 || r.padVelocity.y < 0;
    if (r.padKeepsSideways && slanted) return "jump pads that add to the player's speed";
  }
  return nullptr;
}

float fastestWalk(const level::LevelView& level) {
  float factor = 1;
  for (uint32_t i = 0; i < level.clockCount; ++i) {
    factor = std::max(factor, level.clocks[i].walkFactor);
  }
  return level.params.walkSpeed * factor;
}

float fastestJump(const level::LevelView& level) {
  float fastest = level.params.jumpSpeed;
  for (uint32_t i = 0; i < level.clockCount; ++i) {
    fastest = std::max(fastest, level::jumpSpeedUnder(level.clocks[i], level.params));
  }
  return fastest;
}

}  // namespace obby::solve
