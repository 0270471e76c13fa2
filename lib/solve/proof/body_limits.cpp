#include "solve/proof/body_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body.h"
#include "sim/floor.h"

namespace obby::solve {

namespace {

constexpr float kMinSlope = 80;  // degrees; with a lower maxSlope slides have no speed bound

// Returns r in 1/s: feet at a depth d below a floor rise at most at the speed r d. A negative value
// means that the legs bounce. It is derived from the eigenvalues of one step (docs/proof.md, Legs).
double slowRate(const Params& p) {
  const double dt = p.substepSeconds, c = p.hoverDamping, k = p.hoverStiffness;
  const double sum = 2 - c * dt - k * dt * dt, product = 1 - c * dt;
  const double root = sum * sum - 4 * product;
  if (!(product > 1e-4 && sum > 0 && root > 0)) return -1;
  const double larger = 0.5 * (sum + std::sqrt(root));
  return (1 - larger) / (larger * dt);
}

bool addsSpeed(const level::Roles& r) {
  const bool slanted = r.padVelocity.x != 0 || r.padVelocity.z != 0 || r.padVelocity.y < 0;
  return r.padKeepsSideways && slanted;
}

struct Range {
  float lo, hi;
};

// Returns the min and max gravity of a player.
Range gravityIn(const level::LevelView& level) {
  Range factor{1, 1};
  for (uint32_t i = 0; i < level.clockCount; ++i) {
    factor.lo = std::min(factor.lo, level.clocks[i].gravityFactor);
    factor.hi = std::max(factor.hi, level.clocks[i].gravityFactor);
  }
  return {level.params.gravity * factor.lo, level.params.gravity * factor.hi};
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
  if (level.bodyCount != 0) return "dynamic parts, which can be pushed anywhere";
  if (!(gravityIn(level).lo > 1)) return "almost no gravity";
  if (p.airJumps != 0) return "jumps in the air";
  if (slowRate(p) < 0) return "legs that bounce";
  if (p.moveGain * p.substepSeconds > 1) return "walks that overshoot their speed";
  bool slopes = false;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const uint32_t flags = level.bounds[i].flags;
    slopes |= (flags & level::kSolid) != 0 && (flags & level::kUpright) == 0;
    if ((flags & level::kPad) && addsSpeed(level.roles[level.colliders[i].role])) {
      return "jump pads that add to the player's speed";
    }
  }
  if (slopes && p.maxSlope < kMinSlope * kPi / 180) return "slopes that players slide down";
  return nullptr;
}

BodyLimits::BodyLimits(const Problem& problem, const std::vector<PartMotion>& motions)
    : p_(problem.level.params),
      dt_(p_.substepSeconds),
      tick_(p_.tickSeconds),
      light_(gravityIn(problem.level).lo),
      heavy_(gravityIn(problem.level).hi) {
  setSpeeds(problem, motions);
  setBody();
  setTakeOff();
  setTricks();
}

void BodyLimits::setSpeeds(const Problem& problem, const std::vector<PartMotion>& motions) {
  const level::LevelView& level = problem.level;
  float min = p_.plainGrip;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (level.bounds[i].flags & level::kSolid) min = std::min(min, level.colliders[i].grip);
  }
  decay = std::min(p_.airAccel, p_.traction * min);
  const Box all = allPlaces(problem);
  const float eps = std::numeric_limits<float>::epsilon();
  const float far = std::max({-all.lo.x, all.hi.x, -all.lo.z, all.hi.z}) * eps;
  sim::Motion fast{};
  fast.velocity.y = -std::max(p_.maxFallSpeed, level.maxSideSpeed);
  fast.bottom = p_.headBottom;
  fast.drive.gravity = heavy_;
  const float roundings = float(std::max(sim::contactSplits(fast, p_), 5)) / dt_;
  jump = p_.jumpSpeed;
  slowJump = std::min(p_.jumpSpeed, p_.maxFallSpeed);
  float factor = 1;
  for (uint32_t i = 0; i < level.clockCount; ++i) {
    factor = std::max(factor, level.clocks[i].walkFactor);
    const float boosted = level::jumpSpeedUnder(level.clocks[i], p_);
    jump = std::max(jump, boosted);
    slowJump = std::min(slowJump, boosted);
  }
  walk = p_.walkSpeed * factor + 0.71f * far * roundings;
  const Vec3 start = problem.start.velocity;
  float given = length(Vec3{start.x, 0, start.z});
  for (const PartMotion& m : motions) given = std::max(given, m.sideways);
  fastest_ = walk + std::min(given, 1.42f * level.maxSideSpeed);
  settles = 2 * sim::kSettledGap + std::max(-all.lo.y, all.hi.y) * eps * 128;
  slack = p_.contactSkin + sim::kTight + 0.01f + settles;
}

void BodyLimits::setBody() {
  const float width = p_.bodyWidth, depth = p_.bodyDepth;
  const float half = 0.5f * length(Vec3{width, 0, depth});
  const float min = 0.5f * std::min(width, depth);
  ray = p_.floorRaySpread * 2 * half;
  body = std::max(half, ray) + settles;
  lateTicks_ = (p_.coyoteSteps - 1u) / p_.substeps;
  stand = lateTicks_ > 0 && walk * tick_ >= body - ray ? ray + settles : body;
  limb = 0.5f * length(Vec3{std::max(p_.armSpan, width), 0, depth}) + 1.5f * p_.touchMargin + slack;
  across = 2 * half + slack;
  const float travel = fastest_ * dt_;
  const float step = std::max(std::min(0.9f * min, travel), travel / sim::kMaxSplits);
  turned = half - min + step + slack;
  overlap = std::min(half - min, half * p_.turnSpeed * tick_) + step + slack;
  // A jump that leads through a part in its first tick may end anywhere next to it.
  if (fastest_ * tick_ + slack >= 0.9f * min) overlap = turned;
}

float BodyLimits::fallOver(uint32_t steps, float gravity) const {
  return 0.5f * gravity * dt_ * dt_ * float(steps) * float(steps + 1);
}

float BodyLimits::reachAt(float fall, bool kept) const {
  const float times = kept ? farthestFloor(p_) : p_.floorAcquire;
  const float base = p_.floorReachBase * p_.rootHeight + times * p_.hipHeight;
  return std::max(base, fall * tick_) + std::max(fall - p_.fastFall, 0.0f) * 0.01f -
         sim::rayHeight(p_);
}

void BodyLimits::setTakeOff() {
  const uint32_t n = p_.substeps, landed = p_.landedSteps;
  const uint32_t more = landed > n ? (landed - n + n - 1) / n : 0;
  const uint32_t waits = n * (landed == 0 ? 1 : 1 + std::max(1u, more));  // steps to the first jump
  const uint32_t graced = std::max(p_.graceSteps, p_.coyoteSteps) + n;
  sunk = sim::rayHeight(p_) + fallOver(graced, heavy_);
  keptReach_ = std::max({reachAt(0, true), reachAt(heavy_ * dt_ * float(graced), false), 0.0f});
  // A landing at this speed, on a floor that the rays acquire, leaves a take-off height of 0.
  const float seconds = float(waits) * dt_, fall = fallOver(waits, light_);
  const float speed = std::max(reachAt(0, false) - fall, 0.0f) / seconds;
  for (const float v : {speed, p_.maxFallSpeed}) {
    always_ = std::max(always_, reachAt(v, false) - v * seconds - fall);
  }
  const float fallen = speed * (speed + heavy_ * dt_) / (2 * light_);
  slowest_ = std::max(keptReach_ + fallOver(n, heavy_) + slack, reachAt(speed, false) + fallen);
}

void BodyLimits::setTricks() {
  const auto allows = [&](Trick trick) { return (p_.tricks & trick) != 0; };
  turning = across * (allows(kWallHop) ? kPi / tick_ : p_.turnSpeed);
  if (allows(kWallHop) || allows(kHeldJump)) overlap = turned;
  if (allows(kHangingLanding)) {
    always_ = std::max({always_, reachAt(p_.maxFallSpeed, false), keptReach_});
  }
  if (allows(kHeldJump)) {
    heldRise = keptReach_;
    heldSeconds = (keptReach_ + sunk) / std::max(slowJump, 1e-3f) + 2 * tick_;
  }
  if (allows(kLegThrow)) {
    const float grace = float(std::max(p_.coyoteSteps, p_.graceSteps) + p_.substeps) * dt_;
    always_ = std::max(always_, keptReach_) + thrown(0) * grace;
  }
  maxTakeOff = std::max(keptReach_, always_) + slack;
  late = p_.coyoteTime + 3 * tick_ + heldSeconds;
}

// A tick of steps on the legs is linear: after n steps the speed is gain * depth + kept * speed.
float BodyLimits::thrown(float speed) const {
  if (!(p_.tricks & kLegThrow)) return 0;
  const float stiff = p_.hoverStiffness * dt_, damped = 1 - p_.hoverDamping * dt_;
  const float depth = sim::rayHeight(p_) + speed * tick_;
  float deep[2] = {-1, 0}, fast[2] = {0, 1};  // (gap, speed) per stud of depth and per stud/s
  float max = 0;
  for (uint32_t n = 0; n < p_.substeps; ++n) {
    for (float* s : {deep, fast}) {
      s[1] = damped * s[1] - stiff * s[0];
      s[0] += dt_ * s[1];
    }
    const float kept = std::clamp(fast[1], 0.0f, 0.999f), turns = std::max(-fast[1], 0.0f);
    max = std::max(max, deep[1] * depth / (1 - kept) + turns * p_.maxFallSpeed);
  }
  return max;
}

float BodyLimits::entry(float top, bool pinched) const {
  const float in = pinched ? turned : overlap;
  return top - std::max(sim::rayHeight(p_), p_.hipHeight + in) - slack;
}

float BodyLimits::takeOff(float low, float high) const {
  return low > slowest_ ? always_ : std::max(always_, std::min(high, keptReach_));
}

float BodyLimits::apex(float up, bool leaps) const {
  const float w = std::max(up, 0.0f) + (leaps ? 0.5f * heavy_ * dt_ : 0);
  return w * w / (2 * light_);
}

float BodyLimits::lowApex(float up, bool leaps) const {
  const float w = std::max(up, 0.0f) + (leaps ? 0.5f * light_ * dt_ : 0);
  return w * w / (2 * heavy_);
}

float BodyLimits::airSeconds(float w, float rise) const {
  const float end2 = w * w - 2 * light_ * rise;
  if (end2 < 0 || (rise > 0 && w <= 0)) return -1;
  const float end = sqrtf32(end2), limit = p_.maxFallSpeed;
  if (end <= limit) return (w + end) / light_;
  const float fallen = (limit * limit - w * w) / (2 * light_);
  return (w + limit) / light_ + (-rise - fallen) / limit + 2 * dt_;
}

// A fall off an edge begins with one tick at the edge's height. A jump may use any number of coyote
// ticks, and the longest time counts.
float BodyLimits::seconds(const Flight& f, float height) const {
  const float w = f.up + (f.leaps ? 0.5f * heavy_ : -0.5f * light_) * dt_;
  const uint32_t first = f.leaps ? 0 : 1, last = f.leaps ? lateTicks_ : 1;
  float max = -1;
  for (uint32_t k = first; k <= last; ++k) {
    const float fallen = k > 0 ? fallOver((k - 1) * p_.substeps, light_) : 0;
    const float air = airSeconds(w, height - f.height + fallen);
    if (air < 0) break;
    const float whole = dt_ * std::floor(air / dt_ + 0.01f);
    max = std::max(max, float(k) * tick_ + whole + heldSeconds);
  }
  return max;
}

float BodyLimits::sideways(float seconds, float excess) const {
  if (seconds < 0) return -1;
  float drift = excess * seconds;
  if (decay > 0) {
    const float q = sqrtf32(2 * walk * excess + excess * excess);
    const float unbraked = excess * (tick_ + 2 * dt_) + decay / (p_.moveGain * p_.moveGain);
    drift = std::min(drift, 0.5f * excess * q / decay + unbraked);
  }
  return walk * seconds + drift;
}

float BodyLimits::legsOvershoot(float speed) const {
  const float risen = float(slowRate(p_)) * 1.0001f * tick_;  // studs/tick per stud of depth
  return std::max(risen - 1, 0.0f) * sim::rayHeight(p_) + (risen + 1) * speed * tick_;
}

}  // namespace obby::solve
