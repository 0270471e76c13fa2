#include "solve/proof/supports.h"

#include <algorithm>

#include "sim/seat.h"
#include "solve/proof/body_reach.h"
#include "solve/proof/few_boxes.h"
#include "solve/proof/jumping.h"
#include "solve/proof/pressing.h"

namespace obby::solve {

namespace {

constexpr size_t kMostHeld = 64;   // places in one part where it can hold a body
constexpr float kLeastSlope = 80;  // degrees: below, sliding down makes speeds without a bound

class Builder {
 public:
  explicit Builder(const Problem& problem)
      : problem_(problem), level_(problem.level), p_(level_.params), rise_(springRise(p_)) {}

  std::vector<Support> build() {
    movers_ = problem_.motions != nullptr ? problem_.motions->of(level_) : partMotions(level_);
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      if (level_.bounds[i].flags & level::kSeat) seated_.push_back(seatedBody(i));
    }
    heldSide_ = mostHeldSide();
    addPoint(problem_.start.position);
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      if (!(level_.bounds[i].flags & level::kTeleport)) continue;
      const level::Roles& r = level_.roles[level_.colliders[i].role];
      gates_.push_back(addPoint(r.teleportTo));
      supports_.back().keepsSpeed = r.teleportKeepsVelocity;
    }
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      holds_.push_back(heldIn(level_.bounds[i].box(), level_.bounds[i].flags));
    }
    pressing_ = pressingOf(level_, movers_, holds_, jumpingIn(problem_) != Jumping::never);
    for (uint32_t i = 0; i < level_.colliderCount; ++i) add(i);
    throwOutOfGates();
    return std::move(supports_);
  }

 private:
  // Some teleporters leave the player the speed that anything may have given.
  void throwOutOfGates() {
    const float jump = fastestJump(level_);
    float fastest = 0;
    riseOnSpring(p_, [&](float, float up) { fastest = std::max(fastest, up); });
    for (const Support& s : supports_) {
      fastest = std::max({fastest, s.thrown, std::max(s.upward, s.sprung) + jump});
    }
    for (const Support& s : supports_) {
      if (s.leadsTo == level::kNone) continue;
      const level::Roles& r = level_.roles[level_.colliders[s.collider].role];
      if (r.teleportKeepsVelocity) supports_[s.leadsTo].thrown = fastest;
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

  // How far the body can be from what holds it in a part: no farther than both measure, and than it
  // comes while a jump begins, when the torso does not collide.
  Vec3 mostHeldSide() const {
    float lift = 0;
    for (const PartMotion& m : movers_) lift = std::max(lift, m.upward);
    const float seconds = 3 * p_.tickSeconds;
    const float side = bodyAcross(p_) + seconds * level_.maxSideSpeed;
    return {side, p_.bodyTop + kSlack + seconds * (lift + fastestJump(level_)), side};
  }

  // Where could the body be inside of it without having come in from the side or top?
  std::vector<Box> heldIn(const Box& part, uint32_t flags) const {
    if (!(flags & (level::kSolid | kLeads))) return {};
    const float across = bodyAcross(p_), side = std::max(p_.bodyWidth, 0.5f * across);
    const Vec3 body{side, p_.bodyTop + kSlack, side};
    const Box around = grow(part, {across, body.y, across});
    if (flags & (level::kVanishTimer | level::kClocked)) return {around};
    std::vector<Box> places;
    for (const Support& s : supports_) {
      // Above the floor that the feet may stand on.
      const Box there{s.feet.lo + Vec3{-body.x, 2 * kSlack, -body.z}, s.feet.hi + body};
      if (s.collider != level::kNone || !overlaps(part, there)) continue;
      addBox(places, s.keepsSpeed ? around : grow(there, heldSide_), kMostHeld);
    }
    for (const Box& sitting : seated_) {
      if (overlaps(part, sitting)) addBox(places, grow(sitting, heldSide_), kMostHeld);
    }
    for (const PartMotion& m : movers_) {
      const bool near = m.rough && overlaps(around, m.swept);
      if (near) addBox(places, grow(m.swept, heldSide_), kMostHeld);
    }
    return places;
  }

  void add(uint32_t id) {
    const level::Collider& c = level_.colliders[id];
    const level::Bounds& bounds = level_.bounds[id];
    const PartMotion still{}, *motion = &still;
    if (c.mover != level::kNone) motion = &movers_[moverAt_++];
    if (!(bounds.flags & (level::kSolid | kLeads))) return;
    Support s;
    s.collider = id;
    const Box box = bounds.box();
    s.carries = (bounds.flags & (level::kSolid | level::kSeat)) != 0;
    s.top = box.hi.y;
    const float side = sideOf(bounds.flags);
    s.feet = grow(box, {side, 0, side});
    s.feet.hi.y += riseOn(bounds.flags);
    if (bounds.flags & level::kSeat) s.feet = join(s.feet, seatedIn(box));
    const float above = entryOf(box, bounds.flags, c.mover != level::kNone ? motion : nullptr);
    const float beside = std::min(besideOf(box), above);
    const bool holds = !holds_[id].empty();
    s.entry = holds ? beside : std::max(beside, above - pressedBelow(id));
    s.snaps =
        holds || pressing_.chained[id] || (bounds.flags & (level::kSeat | level::kTeleport)) != 0;
    s.upward = motion->upward;
    addPushes(s, *motion, s.entry > beside);
    if (bounds.flags & (level::kCarries | level::kSeat)) s.sideways = motion->sideways;
    addSurface(s, c, bounds.flags);
    if (bounds.flags & kLeads) s.entry -= unseen_;
    if (bounds.flags & level::kTeleport) s.leadsTo = gates_[gateAt_++];
    supports_.push_back(s);
  }

  // How far above the part the feet can be where it carries, or is touched.
  float riseOn(uint32_t flags) const {
    float rise = (flags & (level::kSolid | level::kSeat)) != 0 ? rise_ : touchSlack(p_);
    if (flags & kLeads) rise = std::max(rise, touchSlack(p_));
    if (!(flags & level::kTruss)) return rise;
    // Who climbs fast is past its top before the sensor misses it.
    const float climbed = climb_ * p_.tickSeconds;
    return std::max(rise, climbed + kSlack - p_.climbLowest * p_.hipHeight);
  }

  // `putsOut`: who is put out of it need not come to be carried by it.
  void addPushes(Support& s, const PartMotion& motion, bool putsOut) const {
    // Out of what it presses somebody into they come as far again at once.
    s.pushes = motion.sideways * (pressing_.presses[s.collider] ? 2.0f : 1.0f);
    s.pushed = s.feet;
    s.bursts = pressing_.bursts[s.collider];
    const float speed = pressing_.speed[s.collider];
    if (!(speed > 0) || (!putsOut && motion.sideways > 0)) return;
    const Box& around = pressing_.around[s.collider];
    s.pushed = motion.sideways > 0 ? join(s.feet, around) : around;
    if (putsOut) s.pushes = std::max(s.pushes, speed);
  }

  // How far from the part's box its player can be, seen from above: body, limbs or climb sensor.
  float sideOf(uint32_t flags) const {
    float side = bodySide(p_) + kSlack;
    if (flags & level::kTruss) side += p_.climbReach;
    return flags & kLeads ? std::max(side, limbSide(p_) + touchSlack(p_)) : side;
  }

  // How far below where a part takes anybody else it takes those who are pressed into it: torso and
  // head, or, as a jump begins, the head.
  float pressedBelow(uint32_t id) const {
    const float depth = pressing_.depth[id];
    return depth > 0 ? depth + p_.headBottom - p_.hipHeight : 0.0f;
  }

  // Torso and head of those who sit there: a seat holds them inside of whatever is there.
  Box seatedBody(uint32_t id) const {
    const level::Collider& c = level_.colliders[id];
    const level::Mover* m = c.mover == level::kNone ? nullptr : &level_.movers[c.mover];
    const Vec3 first = sim::feetOnSeat(m == nullptr ? c.pose : m->keys[0], p_);
    Box feet{first, first};
    if (m != nullptr && m->spinCount != 0) feet = seatedIn(level_.bounds[id].box());
    for (uint32_t k = 1; m != nullptr && k < m->keyCount; ++k) {
      const Vec3 at = sim::feetOnSeat(m->keys[k], p_);
      feet = join(feet, {at, at});
    }
    Vec3 side{0.5f * p_.bodyWidth, 0, 0.5f * p_.bodyDepth};
    const Vec3 back = c.pose.rotation.z;
    const bool turns = m != nullptr || absf(back.x) > 1e-3f * absf(back.z);
    if (turns) side = Vec3{1, 0, 1} * length(side);
    const Box torso{feet.lo + Vec3{0, p_.hipHeight, 0} - side,
                    feet.hi + Vec3{0, p_.bodyTop, 0} + side};
    const float flush = flushDepth(p_);
    return grow(torso, {-flush, -flush, -flush});
  }

  // Feet of those who sit: the root is above the seat's centre, wherever the seat has its top.
  Box seatedIn(const Box& seat) const {
    const float away = p_.seatHeight + kSlack, root = p_.hipHeight + 0.5f * p_.rootHeight;
    return {seat.lo - Vec3{away, away + root, away}, seat.hi + Vec3{away, away - root, away}};
  }

  // From any side, at any height.
  float besideOf(const Box& box) const { return box.lo.y - p_.bodyTop - kSlack - touchSlack(p_); }

  float entryOf(const Box& box, uint32_t flags, const PartMotion* motion) const {
    if (flags & (level::kTruss | kLeads)) return besideOf(box);
    // Rays see a floor from here on, and push-out lifts a torso that is not deeper in it.
    float legs = std::max(sim::rayHeight(p_), p_.hipHeight) + 0.5f * p_.bodyDepth + kSlack;
    if (flags & level::kOneWay) legs += p_.oneWaySlack;
    if (!(flags & level::kUpright)) return box.lo.y - legs;
    return (motion != nullptr ? motion->lowestTop : box.hi.y) - legs;
  }

  void addSurface(Support& s, const level::Collider& c, uint32_t flags) const {
    if (flags & level::kConveyor) {
      const level::Roles& r = level_.roles[c.role];
      const Box around = grow(s.feet, {0, p_.bodyTop, 0});
      Box center{c.pose.position, c.pose.position};  // of the part; or where that can be
      if (c.mover != level::kNone) center = level_.bounds[s.collider].box();
      const Vec3 far = max(abs(around.lo - center.hi), abs(around.hi - center.lo));
      const float turning = length(r.conveyorAngular) * length(far);
      s.sideways += length(Vec3{r.conveyorVelocity.x, 0, r.conveyorVelocity.z}) + turning;
      s.upward += absf(r.conveyorVelocity.y) + turning;
    }
    if (flags & level::kPad) {
      const Vec3 v = level_.roles[c.role].padVelocity;
      s.thrown = std::max(s.thrown, v.y);
      s.down = std::max(-v.y, 0.0f);
      s.sideways = std::max(s.sideways, length(Vec3{v.x, 0, v.z}));
    }
    if (s.carries && climb_ > 0) s.thrown = std::max(s.thrown, climbThrow(p_, climb_, s.upward));
    s.tilted = !(flags & level::kUpright) && s.carries;
    if (s.tilted) s.sideways = std::max(s.sideways, kSteepSpeed);
    if (s.carries && s.upward > 0) s.sprung = springThrow(p_, rise_, s.upward);
  }

  const Problem& problem_;
  const level::LevelView& level_;
  const Params& p_;
  const float rise_, unseen_ = unseenRise(problem_), climb_ = fastestClimb(level_);
  std::vector<PartMotion> movers_;  // of the colliders that move, in their order
  std::vector<Box> seated_;         // torso and head of those who sit
  Vec3 heldSide_;
  Holding holds_;  // (colliders)
  Pressing pressing_;
  std::vector<uint32_t> gates_;  // where teleporters lead, in their order
  size_t moverAt_ = 0, gateAt_ = 0;
  std::vector<Support> supports_;
};

}  // namespace

std::vector<Support> supportsOf(const Problem& problem) { return Builder(problem).build(); }

const char* unboundedPart(const level::LevelView& level) {
  if (level.looseCount != 0) return "dynamic parts, which can be pushed anywhere";
  if (!(level.params.gravity > 1)) return "almost no gravity";
  if (legsBounce(level.params)) return "legs that bounce";
  if (level.params.maxSlope < kLeastSlope * kPi / 180) return "slopes that players slide down";
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

float fastestClimb(const level::LevelView& level) {
  if (!(flagsOfAll(level) & level::kTruss)) return 0;
  return level.params.climbSpeed * fastestWalk(level);
}

float slowestJump(const level::LevelView& level) {
  float slowest = std::min(level.params.jumpSpeed, level.params.maxFallSpeed);
  for (uint32_t i = 0; i < level.clockCount; ++i) {
    slowest = std::min(slowest, level::jumpSpeedUnder(level.clocks[i], level.params));
  }
  return slowest;
}

bool anyHelpless(const level::LevelView& level) {
  return std::any_of(level.clocks, level.clocks + level.clockCount,
                     [](const level::Clock& c) { return c.helpless != 0; });
}

}  // namespace obby::solve
