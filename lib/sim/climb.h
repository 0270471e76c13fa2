// Climbing of trusses: rays that sense a truss ahead, the Climbing state, and its motion
// (docs/physics.md, climbing). It handles one world; no world near a truss is in lanes.
#pragma once

#include "sim/body.h"

namespace obby::sim {

// Rays straight ahead from the player's axis, in rows from the legs to the top of the torso. Only
// the middle column can start a climb. During a climb the two outer columns also hold the player.
constexpr int kClimbRows = 5;

// The truss face ahead.
struct Truss {
  bool sensed = false;
  Vec3 toward;    // unit, horizontal, from the player into the face
  Vec3 velocity;  // velocity of the truss, studs/s
};

struct TrussHit {
  float distance;
  int candidate;  // -1 for none
  Vec3 normal;    // world
};

// Tests whether the first solid part along the ray is a truss, or flush with one. Keeps the nearest
// truss.
OBBY_DEVICE void castForTruss(const level::LevelView& level, const Candidates& near,
                              CandidateSet asked, Vec3 from, Vec3 ahead, TrussHit& best) {
  const float reach = level.params.climbReach;
  float blocked = 1e30f;
  TrussHit truss{1e30f, -1, {}};
  for (CandidateSet left = asked; left != 0; left &= left - 1) {
    const int k = lowestBit(left);
    const Candidate& c = near.items[k];
    const level::Collider& collider = level.colliders[c.collider];
    const Vec3 origin = toLocal(*c.pose, from), direction = toLocal(c.pose->rotation, ahead);
    geom::RayHit hit{};
    const bool met = geom::visitShape(collider.kind, [&](auto shape) {
      return decltype(shape)::castRay(collider.shape, origin, direction, reach, hit);
    });
    if (!met) continue;
    if (!(c.flags & level::kTruss)) {
      blocked = minf(blocked, hit.t);
    } else if (hit.t < truss.distance) {
      truss = {hit.t, k, c.pose->rotation * hit.normal};
    }
  }
  const bool first = truss.distance <= blocked + level.params.contactSkin;
  if (first && truss.distance < best.distance) best = truss;
}

// Returns the solid parts that rays ahead can meet.
OBBY_DEVICE CandidateSet solidsAhead(const Candidates& near, Vec3 feet, const Params& p) {
  const float side = p.climbReach + p.bodyWidth * p.floorRaySpread;
  const Box box{feet + Vec3{-side, 0, -side}, feet + Vec3{side, p.headBottom, side}};
  CandidateSet solids = 0;
  for (int k = 0; k < near.count; ++k) {
    const Candidate& c = near.items[k];
    if ((c.flags & level::kSolid) && overlaps(c.bounds, box)) solids |= CandidateSet(1) << k;
  }
  return solids;
}

// Returns the nearest truss that a column of rays meets.
OBBY_DEVICE TrussHit castColumn(const level::LevelView& level, const Candidates& near,
                                CandidateSet solids, Vec3 feet, Vec3 ahead) {
  const Params& p = level.params;
  const float lowest = p.hipHeight * p.climbLowest;
  const float spacing = (p.headBottom - lowest) / float(kClimbRows - 1);
  TrussHit best{1e30f, -1, {}};
  for (int row = 0; row < kClimbRows; ++row) {
    const Vec3 from = feet + Vec3{0, lowest + spacing * float(row), 0};
    castForTruss(level, near, solids, from, ahead, best);
  }
  if (!(near.anyFlags & level::kRung)) return best;
  // Rungs are thinner than the spacing of the rows, so each gets a ray at its own height.
  for (CandidateSet left = solids; left != 0; left &= left - 1) {
    const Candidate& c = near.items[lowestBit(left)];
    const float height = c.pose->position.y - feet.y;
    if (!(c.flags & level::kRung) || height < lowest || height > p.headBottom) continue;
    castForTruss(level, near, solids, feet + Vec3{0, height, 0}, ahead, best);
  }
  return best;
}

// Returns the truss face ahead of a player.
OBBY_DEVICE TrussHit findTruss(const Player& player, const level::LevelView& level,
                               const Candidates& near) {
  const Params& p = level.params;
  const SinCos yaw = sinCosOf<float>(player.yaw);
  const Vec3 ahead = directionOf(yaw);
  const Vec3 aside = Vec3{yaw.cos, 0, -yaw.sin} * (p.bodyWidth * p.floorRaySpread);
  const CandidateSet solids = solidsAhead(near, player.position, p);
  TrussHit best = castColumn(level, near, solids, player.position, ahead);
  if (player.is(State::climbing)) {
    // At a corner the outer columns can meet a face other than the climbed one.
    for (int side = -1; side <= 1 && best.candidate < 0; side += 2) {
      best = castColumn(level, near, solids, player.position + aside * float(side), ahead);
    }
  }
  return best;
}

OBBY_DEVICE Truss senseTruss(const World& w, const RigidBody* bodies, const Player& player,
                             const level::LevelView& level, const Candidates& near) {
  const Vec3 ahead = directionOf(sinCosOf<float>(player.yaw));
  const TrussHit best = findTruss(player, level, near);
  if (best.candidate < 0) return {};
  const Vec3 flat{-best.normal.x, 0, -best.normal.z};
  const float size = length(flat);
  Floor surface;  // conveyors and carrying parts move a climber as they move a walker
  surfaceMotion(w, bodies, level, near.items[best.candidate], surface);
  return {true, size > level.params.climbWill ? flat * (1.0f / size) : ahead, surface.velocity};
}

// Returns 1 if the move direction points into the truss, -1 if it points away, otherwise 0.
OBBY_DEVICE float climbWill(const Params& p, const Truss& truss, const ControlT<float>& control) {
  if (!control.walk) return 0;
  const float into = dot(directionOf(sinCosOf<float>(control.heading)), truss.toward);
  return into >= p.climbWill ? 1.0f : into <= -p.climbWill ? -1.0f : 0.0f;
}

OBBY_DEVICE void leaveTruss(Player& w, const Params& p, const Truss& truss) {
  w.state = int32_t(State::jumping);
  w.velocity = truss.velocity + Vec3{0, p.jumpSpeed, 0};
  w.freeSteps = 1;
  w.leftTruss = true;
  w.jumps = countedOn(w.jumps, 1);
  w.floorlessSteps = int32_t(p.coyoteSteps);  // one jump per take-off
}

// Beyond the end of the truss the climb continues while it leads onto a floor that is still above
// the feet. Then the player stands on the floor, without a leap.
OBBY_DEVICE void passTruss(Player& w, const Params& p, const Floor& floor, Truss& truss,
                           const ControlT<float>& control) {
  truss.toward = directionOf(sinCosOf<float>(w.yaw));
  truss.velocity = floor.velocity;
  const float step = climbSpeedOf(p) * p.tickSeconds;
  if (floor.sensed && floor.gap < -step && climbWill(p, truss, control) > 0) return;
  // The coyote time is over, so running without a floor would become freefall.
  w.state = int32_t(floor.sensed ? State::running : State::freefall);
  if (floor.sensed) w.velocity.y = minf(w.velocity.y, floor.velocity.y);
}

// Enters and leaves the Climbing state. Runs after updateState(). `p` includes the player's
// boosts. Returns the truss that is climbed.
OBBY_DEVICE Truss updateClimbing(const World& w, const RigidBody* bodies, Player& player,
                                 const level::LevelView& level, const Params& p,
                                 const Candidates& near, const Floor& floor,
                                 const ControlT<float>& control) {
  const bool climbs = player.is(State::climbing);
  const bool free = player.is(State::running) || player.is(State::freefall);
  Truss truss;
  if ((near.anyFlags & level::kTruss) && (climbs || (free && control.walk))) {
    truss = senseTruss(w, bodies, player, level, near);
  }
  const float will = climbWill(p, truss, control);
  if (!climbs) {
    // A rising player can also start to climb, but not right after a jump off a truss: that is a
    // flick.
    const bool flicks = player.leftTruss && !(p.tricks & kLadderFlick);
    if (truss.sensed && will > 0 && !flicks) player.state = int32_t(State::climbing);
  } else if (!truss.sensed) {
    passTruss(player, p, floor, truss, control);
  } else if (control.jump) {
    leaveTruss(player, p, truss);
  } else if (floor.sensed && will < 0) {
    player.state = int32_t(State::running);
  }
  return truss;
}

// Returns a climber's control, which faces the truss whatever the keys say.
OBBY_DEVICE ControlT<float> facing(const Truss& truss, const ControlT<float>& control) {
  return {headingOf(truss.toward.x, truss.toward.z), true, control.jump};
}

// Moves a climber by one tick, toward the speed of the climb and without gravity. On the way up the
// body is also pressed against the truss. This moves it over the top once the hips are clear.
OBBY_DEVICE void moveClimber(Motion& m, const Truss& truss, const ControlT<float>& control,
                             const level::LevelView& level, const Params& p,
                             const Candidates& near) {
  const float will = climbWill(p, truss, control), speed = climbSpeedOf(p);
  const float press = will > 0 ? minf(speed, p.walkSpeed) : 0.0f;
  const Vec3 wanted = truss.velocity + truss.toward * press + Vec3{0, will * speed, 0};
  const CandidateSet solids = solidsInReach(m, level, near);
  const float dt = p.substepSeconds, share = minf(p.moveGain * dt, 1.0f);
  if (length(wanted - m.velocity) < kSettledSpeed) m.velocity = wanted;
  for (int s = 0; s < p.substeps; ++s) {
    m.velocity = bounded(m.velocity + (wanted - m.velocity) * share, level);
    moveAmong(m, level, near, solids, dt);
  }
}

}  // namespace obby::sim
