#include "level/speeds.h"

namespace obby::level {
namespace {

constexpr float kMaxGiven = 500;  // studs/s

float sideways(Vec3 v) { return length(Vec3{v.x, 0, v.z}); }

// Returns how far a point one stud from the axis moves between two rotations, in a straight line.
float turnBetween(const Mat3& a, const Mat3& b) {
  const Vec3 x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return sqrtf32(0.5f * (dot(x, x) + dot(y, y) + dot(z, z)));
}

// Returns, for each mover, the max distance from its centre at which its parts carry a player, in
// studs; 0 if they carry none.
std::vector<float> reachOfMovers(const PartTables& t) {
  std::vector<float> reach(t.movers.size(), 0.0f);
  for (size_t i = 0; i < t.colliders.size(); ++i) {
    const Collider& c = t.colliders[i];
    if (c.mover == kNone || !(t.bounds[i].flags & (kCarries | kSeat))) continue;
    reach[c.mover] = maxf(reach[c.mover], length(c.shape.half) + length(t.movers[c.mover].pivot));
  }
  return reach;
}

// Returns the max sideways speed of a point at `reach` studs from the mover's centre, studs/s.
float speedOf(const Mover& m, float reach, const Params& params) {
  // All steps of a spin are equal.
  const float spin = m.spinCount > 1 ? turnBetween(m.spins[0], m.spins[1]) * reach : 0;
  float limit = spin;
  for (uint32_t k = 0; k + 1 < m.keyCount; ++k) {
    const Pose &from = m.keys[k], &to = m.keys[k + 1];
    const float turn = turnBetween(from.rotation, to.rotation) * reach;
    limit = maxf(limit, sideways(to.position - from.position) + turn + spin);
  }
  return limit * float(params.controlRate);
}

// Returns the max sideways speed of a conveyor's surface, studs/s. `box` is the part's bounds. A
// moving part may have any orientation.
float speedOf(const Roles& r, const Collider& c, const Box& box) {
  const Vec3 turning = abs(r.conveyorAngular);
  const Vec3 far = max(abs(box.lo - c.pose.position), abs(box.hi - c.pose.position));
  const bool moves = c.mover != kNone || c.body != kNoBody;
  const float radius = moves ? length(c.shape.half) : sideways(far);
  const float above = moves ? length(c.shape.half) : far.y;
  return sideways(r.conveyorVelocity) + turning.y * radius + sideways(turning) * above;
}

}  // namespace

float fastestSideways(const PartTables& tables, const Params& params) {
  float walk = 1, given = 0;
  for (const Clock& c : tables.clocks) walk = maxf(walk, c.walkFactor);
  for (const Roles& r : tables.roles) given = maxf(given, sideways(r.padVelocity));
  const std::vector<float> reach = reachOfMovers(tables);
  std::vector<float> speeds;
  for (size_t i = 0; i < tables.movers.size(); ++i) {
    speeds.push_back(speedOf(tables.movers[i], reach[i], params));
    given = maxf(given, speeds.back());
  }
  for (size_t i = 0; i < tables.colliders.size(); ++i) {
    const Collider& c = tables.colliders[i];
    const Bounds& bounds = tables.bounds[i];
    if (!(bounds.flags & kConveyor)) continue;
    const float carried = bounds.flags & kCarries ? speeds[c.mover] : 0;
    given = maxf(given, speedOf(tables.roles[c.role], c, bounds.box()) + carried);
  }
  return params.walkSpeed * walk + minf(given, kMaxGiven);
}

float fastestJump(const PartTables& tables, const Params& params) {
  float fastest = params.jumpSpeed;
  for (const Clock& c : tables.clocks) fastest = maxf(fastest, jumpSpeedUnder(c, params));
  return fastest;
}

}  // namespace obby::level
