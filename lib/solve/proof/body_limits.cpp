#include "solve/proof/body_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body.h"
#include "sim/floor.h"

namespace obby::solve {

namespace {

constexpr float kLeastSlope = 80;  // degrees: below, sliding makes speeds without a bound

// The discrete spring of the legs: eigenvalues of one step (docs/proof.md, legs).
struct Spring {
  double sum, product, root;  // of the characteristic polynomial
  explicit Spring(const Params& p) {
    const double dt = p.substepSeconds, c = p.hoverDamping, k = p.hoverStiffness;
    sum = 2 - c * dt - k * dt * dt;
    product = 1 - c * dt;
    root = sum * sum - 4 * product;
  }
  bool bounces() const { return !(product > 1e-4 && sum > 0 && root > 0); }
  // 1/s: feet below a floor by d rise at most at this times d.
  double slowRate(double dt) const {
    const double mu = 0.5 * (sum + std::sqrt(std::max(root, 0.0)));
    return (1 - mu) / (mu * dt);
  }
};

bool addsSpeed(const level::Roles& r) {
  const bool slanted = r.padVelocity.x != 0 || r.padVelocity.z != 0 || r.padVelocity.y < 0;
  return r.padKeepsSideways && slanted;
}

}  // namespace

Box allPlaces(const Problem& problem) {
  const Vec3 start = problem.start.position;
  const level::LevelView& level = problem.level;
  Box all = join(problem.bounds, Box{start, start});
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (!(level.bounds[i].flags & level::kTeleport)) continue;
    const Vec3 to = level.roles[level.colliders[i].role].teleportTo;
    all = join(all, Box{to, to});
  }
  return all;
}

const char* unboundedPart(const level::LevelView& level) {
  const Params& p = level.params;
  if (level.looseCount != 0) return "dynamic parts, which can be pushed anywhere";
  if (!(p.gravity > 1)) return "almost no gravity";
  if (Spring(p).bounces()) return "legs that bounce";
  bool slopes = false;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const uint32_t flags = level.bounds[i].flags;
    slopes |= (flags & level::kSolid) != 0 && (flags & level::kUpright) == 0;
    if ((flags & level::kPad) && addsSpeed(level.roles[level.colliders[i].role])) {
      return "jump pads that add to the player's speed";
    }
  }
  if (slopes && p.maxSlope < kLeastSlope * kPi / 180) return "slopes that players slide down";
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

BodyLimits::BodyLimits(const Problem& problem, const std::vector<PartMotion>& motions)
    : p_(problem.level.params),
      dt_(p_.substepSeconds),
      tick_(p_.tickSeconds),
      gravity_(p_.gravity) {
  setSpeeds(problem, motions);
  setBody();
  setTakeOff();
  setTricks();
}

void BodyLimits::setSpeeds(const Problem& problem, const std::vector<PartMotion>& motions) {
  const level::LevelView& level = problem.level;
  float least = p_.plainGrip, most = p_.plainGrip;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (!(level.bounds[i].flags & level::kSolid)) continue;
    least = std::min(least, level.colliders[i].grip);
    most = std::max(most, level.colliders[i].grip);
  }
  const float strongest = std::max({p_.traction * most, p_.airAccel, p_.jumpAccel});
  const float overshoot = std::max(strongest * (dt_ - 1 / p_.moveGain), 0.0f);
  const Box all = allPlaces(problem);
  const float eps = std::numeric_limits<float>::epsilon();
  const float far = std::max({-all.lo.x, all.hi.x, -all.lo.z, all.hi.z}) * eps;
  sim::Motion fast{};
  fast.velocity.y = -std::max(p_.maxFallSpeed, level.maxSideSpeed);
  fast.bottom = p_.headBottom;
  const float cuts = std::ceil(sim::substepTravel(fast, p_) / sim::safeTravel(fast, p_));
  const float pieces = std::clamp(cuts, 5.0f, float(sim::kMostSplits));
  walk = fastestWalk(level) + overshoot + 0.71f * far * pieces / dt_;
  const Vec3 start = problem.start.velocity;
  float given = length(Vec3{start.x, 0, start.z});
  for (const PartMotion& m : motions) given = std::max(given, m.sideways);
  fastest = walk + std::min(given, 1.42f * level.maxSideSpeed);
  jump = fastestJump(level);
  slowJump = std::min(p_.jumpSpeed, p_.maxFallSpeed);
  for (uint32_t i = 0; i < level.clockCount; ++i) {
    slowJump = std::min(slowJump, level::jumpSpeedUnder(level.clocks[i], p_));
  }
  decay = std::min(p_.airAccel, p_.traction * least);
  settles = 2 * sim::kSettledGap + std::max(-all.lo.y, all.hi.y) * eps * 128;
  slack = p_.contactSkin + sim::kTight + 0.01f + settles;
}

void BodyLimits::setBody() {
  const float width = p_.bodyWidth, depth = p_.bodyDepth;
  const float half = 0.5f * length(Vec3{width, 0, depth});
  const float least = 0.5f * std::min(width, depth);
  ray = p_.floorRaySpread * 2 * half;
  body = std::max(half, ray) + settles;
  stand = walk * tick_ >= body - ray ? ray + settles : body;
  limb = 0.5f * length(Vec3{std::max(p_.armSpan, width), 0, depth}) + 1.5f * p_.touchMargin + slack;
  across = 2 * half + slack;
  const float travel = fastest * dt_;
  const float step = std::max(std::min(0.9f * least, travel), travel / sim::kMostSplits);
  turned = half - least + step + slack;
  overlap = std::min(half - least, half * p_.turnSpeed * tick_) + step + slack;
  // A jump that leads through a part in a tick may end anywhere beside it.
  staysOut = fastest * tick_ + slack < 0.9f * least;
  if (!staysOut) overlap = turned;
}

float BodyLimits::fallOver(uint32_t steps) const {
  return 0.5f * gravity_ * dt_ * dt_ * float(steps) * float(steps + 1);
}

float BodyLimits::reachAt(float fall, bool kept) const {
  const float times = kept ? farthestFloor(p_) : p_.floorAcquire;
  const float base = p_.floorReachBase * p_.rootHeight + times * p_.hipHeight;
  return std::max(base, fall * tick_) + std::max(fall - p_.fastFall, 0.0f) * 0.01f -
         sim::rayHeight(p_);
}

float BodyLimits::settled(float speed) const {
  return reachAt(speed, false) - speed * float(landedSteps_) * dt_ - fallOver(landedSteps_);
}

void BodyLimits::setTakeOff() {
  const uint32_t n = p_.substeps, landed = p_.landedSteps;
  const uint32_t more = landed > n ? (landed - n + n - 1) / n : 0;
  landedSteps_ = n * (landed == 0 ? 1 : 1 + std::max(1u, more));
  lateTicks_ = (p_.coyoteSteps - 1u) / n;
  const uint32_t graced = std::max(p_.graceSteps, p_.coyoteSteps) + n;
  graceFall_ = fallOver(graced);
  sunk_ = sim::rayHeight(p_) + graceFall_;
  keptReach_ = std::max({reachAt(0, true), reachAt(gravity_ * dt_ * float(graced), false), 0.0f});
  always_ = std::max(settled(p_.maxFallSpeed), 0.0f);
  slowRate_ = float(Spring(p_).slowRate(dt_)) * 1.0001f;
}

void BodyLimits::setTricks() {
  const auto allows = [&](Trick trick) { return (p_.tricks & trick) != 0; };
  turning = across * (allows(kWallHop) ? kPi / tick_ : p_.turnSpeed);
  if (allows(kWallHop) || allows(kHeldJump)) overlap = turned;
  if (allows(kHangingLanding)) {
    always_ = std::max({always_, reachAt(p_.maxFallSpeed, false), keptReach_});
  }
  if (allows(kHeldJump)) {
    staysOut = false;
    heldSeconds = (keptReach_ + sunk_) / std::max(slowJump, 1e-3f) + 2 * tick_;
  }
  if (allows(kLegThrow)) setThrown();
  // What a landing leaves is highest at an end of the speeds (docs/proof.md, take-off), and without
  // one the feet are within the rays' kept length, or a tick's fall of it.
  landedTakeOff =
      std::max({always_, keptReach_, std::max(reachAt(0, true), reachAt(0, false)) + nearRest()});
}

// The map of a tick's steps on the legs is linear: the speed after n of them is gain * depth + kept
// * speed.
void BodyLimits::setThrown() {
  const float stiff = p_.hoverStiffness * dt_, damped = 1 - p_.hoverDamping * dt_;
  float deep[2] = {-1, 0}, fast[2] = {0, 1};  // gap and speed, of a stud below and of a stud/s
  for (uint32_t n = 0; n < p_.substeps; ++n) {
    for (float* s : {deep, fast}) {
      s[1] = damped * s[1] - stiff * s[0];
      s[0] += dt_ * s[1];
    }
    const float kept = std::clamp(fast[1], 0.0f, 0.999f), turns = std::max(-fast[1], 0.0f);
    throwGain_ = std::max(throwGain_, deep[1] / (1 - kept));
    thrown = std::max(thrown, deep[1] * sim::rayHeight(p_) / (1 - kept) + turns * p_.maxFallSpeed);
  }
  const float late = float(std::max(p_.coyoteSteps, p_.graceSteps) + p_.substeps) * dt_;
  always_ = std::max(always_, keptReach_) + thrown * late;
}

float BodyLimits::letGo(float takeOff, float up) const {
  if (!(p_.tricks & kHeldJump)) return takeOff;
  return std::max(takeOff, keptReach_) + up * tick_;
}

float BodyLimits::entryFalling(float top) const {
  return top - std::max(sim::rayHeight(p_), p_.hipHeight + turned) - slack;
}

float BodyLimits::entryLeaping(float top, bool pinched) const {
  const float in = pinched ? turned : overlap;
  return top - std::max(sim::rayHeight(p_), p_.hipHeight + in) - slack;
}

float BodyLimits::takeOff(Span heads, float rising) const {
  if (heads.hi <= 0) return always_;
  // Who lands on a floor that goes up may go up as fast.
  const float fall = fallOver(landedSteps_) - rising * float(landedSteps_) * dt_;
  const float near = nearRest();
  const float kept = std::max(reachAt(0, true), reachAt(0, false));
  float most = always_;
  if (heads.hi <= kept + near) {
    most = std::max(most, std::min(heads.hi - fall, heads.hi));
  } else if (heads.lo <= kept + near) {
    most = std::max(most, kept - fall);
  } else {
    const float above = std::max(heads.lo - reachAt(0, false), 0.0f);
    // v^2 + v g dt = 2 g (head - gap)
    const float step = 0.5f * gravity_ * dt_;
    const float speed = sqrtf32(step * step + 2 * gravity_ * above) - step;
    most = std::max(most, settled(speed));
  }
  return most;
}

float BodyLimits::keptTakeOff(float drop) const {
  if (drop <= 0 || drop > graceFall_ + keptReach_ + slack) return 0;
  return std::min(drop, keptReach_);
}

float BodyLimits::mostTakeOff() const { return std::max(keptReach_, always_) + slack; }

float BodyLimits::leapApex(float up) const {
  const float w = up + 0.5f * gravity_ * dt_;
  return w * w / (2 * gravity_);
}

float BodyLimits::fallApex(float up) const { return up > 0 ? up * up / (2 * gravity_) : 0; }

float BodyLimits::airSeconds(float w, float rise) const {
  const float end2 = w * w - 2 * gravity_ * rise;
  if (end2 < 0 || (rise > 0 && w <= 0)) return -1;
  const float end = sqrtf32(end2), limit = p_.maxFallSpeed;
  if (end <= limit) return (w + end) / gravity_;
  const float fallen = (limit * limit - w * w) / (2 * gravity_);
  return (w + limit) / gravity_ + (-rise - fallen) / limit + 2 * dt_;
}

float BodyLimits::leapSeconds(float up, float rise) const {
  const float w = up + 0.5f * gravity_ * dt_;
  float most = -1;
  for (uint32_t k = 0; k <= lateTicks_; ++k) {
    const float fallen = k > 0 ? fallOver((k - 1) * p_.substeps) : 0;
    const float air = airSeconds(w, rise + fallen);
    if (air < 0) break;
    most = std::max(most, float(k) * tick_ + dt_ * std::floor(air / dt_ + 0.01f));
  }
  return most;
}

float BodyLimits::fallSeconds(float up, float rise) const {
  const float w = up - 0.5f * gravity_ * dt_;
  const float air = airSeconds(w, rise);
  return air < 0 ? -1 : tick_ + dt_ * std::floor(air / dt_ + 0.01f);
}

float BodyLimits::sideways(float seconds, float excess) const {
  if (seconds < 0) return -1;
  const float all = excess * seconds;
  if (!(excess > 0) || !(decay > 0)) return walk * seconds + std::max(all, 0.0f);
  const float q = sqrtf32(2 * walk * excess + excess * excess);
  float drift = 0.5f * excess * q / decay;
  if (walk > 0) drift = std::min(drift, q * q * q / (6 * walk * decay));
  drift += excess * (tick_ + 2 * dt_) + decay / (p_.moveGain * p_.moveGain);
  return walk * seconds + std::min(all, drift);
}

float BodyLimits::legsOvershoot(float speed) const {
  const float down = std::max(slowRate_ * tick_ - 1, 0.0f) * sim::rayHeight(p_);
  return down + (slowRate_ * tick_ + 1) * speed * tick_;
}

}  // namespace obby::solve
