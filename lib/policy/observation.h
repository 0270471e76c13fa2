// The policy's observation: the player's state, its next target, and the ground around it
// (columns.h) now and shortly after. The frame looks toward the next region. kObservationVersion
// changes whenever the meaning of a number here changes.
#pragma once

#include "policy/body_view.h"
#include "policy/look_around.h"

namespace obby::policy {

constexpr uint32_t kObservationVersion = 2;

// The order of inputs: the player's state, the nearest dynamic body (body_view.h), the maps
// (columns.h), and zeros that pad a row to the widest lanes. All except the state are kEmptyInput
// if nothing is in sight.
constexpr int kStateInputs = 27;
constexpr int kMapsAt = kStateInputs + kBodyInputs;
constexpr int kSpareInputs = 11;
constexpr int kInputs = kMapsAt + kMaps * kPoints + kSpareInputs;  // 288

// Returns the direction of the frame, toward the centre of the next region. Right above or below
// the region it is the player's facing.
OBBY_DEVICE Turns aheadOf(const geom::Region& next, const sim::World& w) {
  const float x = next.pose.position.x - w.position.x, z = next.pose.position.z - w.position.z;
  return x * x + z * z < 0.25f ? w.yaw : headingOf(x, z);
}

// Returns true if a jump can begin at the next tick, or soon after landing.
OBBY_DEVICE bool mayJump(const level::LevelView& level, const sim::World& w) {
  if (w.state == sim::State::climbing || w.state == sim::State::seated) return true;
  return (w.state == sim::State::running || w.state == sim::State::landed) &&
         w.floorlessSteps < level.params.coyoteSteps;
}

// Times in inputs are in ticks of 1/60 s. Returns the length of a tick of the level in that unit.
OBBY_DEVICE float ticksOfSixty(const level::LevelView& level) {
  return 60.0f / float(level.params.controlRate);
}

// Writes the player's state: kStateInputs numbers of order 1.
OBBY_DEVICE void observeState(const Scene& s, const sim::World& w, const sim::NextRegion& next,
                              const Frame& frame, float* out) {
  const Params p = w.clockCount == 0 ? s.level.params : sim::boosted(w, s.level);
  const Vec3 to = next.region->pose.position - w.position;
  const float flat = sqrtf32(to.x * to.x + to.z * to.z);
  const float tick = ticksOfSixty(s.level);
  const auto in = [&](sim::State state) { return w.state == state ? 1.0f : 0.0f; };
  int i = 0;
  // Velocity: forward and to the right in units of 16 studs/s, upward in units of 50.
  out[i++] = dot(w.velocity, frame.forward) * 0.0625f;
  out[i++] = dot(w.velocity, frame.right) * 0.0625f;
  out[i++] = clampf(w.velocity.y * 0.02f, -3.0f, 3.0f);
  // 1 if a floor was sensed in the last step; the time since the last floor, 1 at half a second.
  out[i++] = w.floorlessSteps == 0 ? 1.0f : 0.0f;
  out[i++] =
      minf(float(w.floorlessSteps) * (tick / float(s.level.params.substeps)), 30.0f) * 0.0333f;
  // Indicators of the states, then of a possible jump.
  out[i++] = in(sim::State::running) + in(sim::State::landed);
  out[i++] = in(sim::State::landed);
  out[i++] = in(sim::State::jumping);
  out[i++] = in(sim::State::freefall);
  out[i++] = in(sim::State::climbing);
  out[i++] = in(sim::State::seated) + in(sim::State::fallingDown);
  out[i++] = mayJump(s.level, w) ? 1.0f : 0.0f;
  // The next region: its distance and height far away and nearby, and its half size.
  out[i++] = squashed(flat, 16.0f);
  out[i++] = minf(flat, 16.0f) * 0.0625f;
  out[i++] = squashed(to.y, 8.0f);
  out[i++] = clampf(to.y * 0.125f, -2.0f, 2.0f);
  out[i++] = minf(next.region->half.x + next.region->half.z, 16.0f) * 0.0625f;
  out[i++] = minf(next.region->half.y, 8.0f) * 0.125f;
  const SinCos facing = sinCos(Turns(w.yaw - frame.ahead));
  out[i++] = facing.sin;
  out[i++] = facing.cos;
  // Jumps left, up to 4; time left, 1/2 at 4 s.
  const uint32_t jumps = sim::jumpsLeft(s.query, w);
  out[i++] = float(jumps < 4 ? jumps : 4) * 0.25f;
  const uint32_t limit = s.query.timeLimitTicks;
  const float left =
      limit == 0 ? 600.0f : (float(limit) - float(sim::ticksPlayed(w, s.query))) * tick;
  out[i++] = squashed(maxf(left, 0.0f), 240.0f);
  // The body: health, walk speed in units of 16 studs/s, width of a jump in units of 10 studs and
  // its height in units of 8.
  out[i++] = w.health / p.maxHealth;
  out[i++] = p.walkSpeed * 0.0625f;
  const float reach = 2 * p.jumpSpeed * p.walkSpeed / maxf(p.gravity, 1.0f);
  out[i++] = minf(reach, 30.0f) * 0.1f;
  out[i++] = minf(0.5f * p.jumpSpeed * p.jumpSpeed / maxf(p.gravity, 1.0f), 30.0f) * 0.125f;
  out[i++] = w.waypoints < s.query.waypointCount ? 1.0f : 0.0f;  // 1 if a waypoint is left
}

// Writes all inputs except the maps.
OBBY_DEVICE void observeOthers(const Scene& s, const sim::World& w, const sim::RigidBody* bodies,
                               const sim::NextRegion& next, Turns ahead, float* inputs) {
  const Frame frame(ahead);
  observeState(s, w, next, frame, inputs);
  tellBodies(s.level, w, bodies, frame, inputs + kStateInputs);
  for (int i = kInputs - kSpareInputs; i < kInputs; ++i) inputs[i] = kEmptyInput;
}

// Fills `inputs` (kInputs) with the observation of a player who is to reach `next`, in a frame that
// looks `ahead`. `bodies` has level.bodyCount bodies.
template <class F>
OBBY_DEVICE void observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
                         const sim::NextRegion& next, Turns ahead, float* inputs) {
  Rosette rosette;
  placePoints(ahead, rosette);
  Maps<F, kPaddedPoints> maps;
  lookAround(scene, world, bodies, [&](const Sight& sight) { maps.see(rosette, sight); });
  maps.finish();
  observeOthers(scene, world, bodies, next, ahead, inputs);
  float* out = inputs + kMapsAt;
  for (const auto& moment : maps.heights) {
    for (const auto& kind : moment) {
      for (int i = 0; i < kPoints; ++i) *out++ = kind[i];
    }
  }
}

// Parts of an observation that can be computed separately: one for each point, and one for the
// rest.
constexpr int kViewParts = kPoints + 1;
// The number of parts rounded up, so that a warp works on one world only. All its threads then
// visit the same colliders.
constexpr uint32_t kViewThreads = 64;
static_assert(kViewParts <= int(kViewThreads));

// Computes one part, for devices with a thread for each. All parts together have the bits of
// observe().
OBBY_DEVICE void observePart(const Scene& scene, const sim::World& world,
                             const sim::RigidBody* bodies, const sim::NextRegion& next, Turns ahead,
                             int part, float* inputs) {
  if (part == kPoints) {
    observeOthers(scene, world, bodies, next, ahead, inputs);
    return;
  }
  const Points<1> point = placePoint(ahead, part);
  Maps<float, 1> maps;
  lookAround(scene, world, bodies, [&](const Sight& sight) { maps.see(point, sight); });
  maps.finish();
  float* out = inputs + kMapsAt + part;
  for (const auto& moment : maps.heights) {
    for (const auto& kind : moment) {
      *out = kind[0];
      out += kPoints;
    }
  }
}

// Fills `inputs` with the observation toward the query's next region. Returns the direction of its
// frame.
template <class F>
OBBY_DEVICE Turns observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
                          float* inputs) {
  const sim::NextRegion next = nextRegion(scene.query, world);
  const Turns ahead = aheadOf(*next.region, world);
  observe<F>(scene, world, bodies, next, ahead, inputs);
  return ahead;
}

}  // namespace obby::policy
