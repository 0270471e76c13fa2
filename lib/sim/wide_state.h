// Converts the players of kLanes worlds from and to rows. Also converts the motions of a block of
// worlds from and to arrays, so that any of these motions can share lanes.
#pragma once

#include <stddef.h>

#include <bit>

#include "sim/actions.h"
#include "sim/body.h"
#include "simd/rows.h"

namespace obby::sim {

using WidePlayer = PlayerT<WideFloat>;
using WideMotion = MotionT<WideFloat>;

// Words of a world's row.
enum WorldWord {
  kPositionWord = 0,
  kVelocityWord = 3,
  kHealthWord = 6,
  kTickWord = 7,
  kYawJumpsWord = 9,
  kFloorlessHurtWord = 10,
  kStateWord = 11,  // landedSteps, waypoints, state, outcome
  kFlagsWord = 12
};
static_assert(std::endian::native == std::endian::little, "halves of words are read as such");
static_assert(offsetof(World, position) == 4 * kPositionWord &&
              offsetof(World, velocity) == 4 * kVelocityWord &&
              offsetof(World, health) == 4 * kHealthWord &&
              offsetof(World, tick) == 4 * kTickWord && offsetof(World, yaw) == 4 * kYawJumpsWord &&
              offsetof(World, jumps) == 4 * kYawJumpsWord + 2 &&
              offsetof(World, floorlessSteps) == 4 * kFloorlessHurtWord &&
              offsetof(World, hurtTicks) == 4 * kFloorlessHurtWord + 2 &&
              offsetof(World, landedSteps) == 4 * kStateWord &&
              offsetof(World, state) == 4 * kStateWord + 2 &&
              offsetof(World, outcome) == 4 * kStateWord + 3 &&
              offsetof(World, flags) == 4 * kFlagsWord);

OBBY_LANES Vec3T<WideFloat> vectorAt(const Rows& rows, int word) {
  return {floatOfBits(rows.word[word]), floatOfBits(rows.word[word + 1]),
          floatOfBits(rows.word[word + 2])};
}
OBBY_LANES void putVector(Rows& rows, int word, Vec3T<WideFloat> v) {
  rows.word[word] = bitsOf(v.x);
  rows.word[word + 1] = bitsOf(v.y);
  rows.word[word + 2] = bitsOf(v.z);
}

OBBY_LANES WidePlayer playerOf(const Rows& rows) {
  const WideInt yawJumps = rows.word[kYawJumpsWord], state = rows.word[kStateWord];
  WidePlayer p;
  p.position = vectorAt(rows, kPositionWord);
  p.velocity = vectorAt(rows, kVelocityWord);
  p.yaw = yawJumps & 0xffff;
  p.jumps = (yawJumps >> 16) & 0xffff;
  p.floorlessSteps = rows.word[kFloorlessHurtWord] & 0xffff;
  p.landedSteps = state & 0xff;
  p.state = (state >> 16) & 0xff;
  p.sensed = (rows.word[kFlagsWord] & kFloorSensed) != 0;
  p.lifted = (rows.word[kFlagsWord] & kLegsLift) != 0;
  p.leftTruss = (rows.word[kFlagsWord] & kLeftTruss) != 0;
  return p;
}

// Returns the controls of kLanes worlds. `index` has kLanes indices into `actions`.
OBBY_LANES ControlT<WideFloat> controlsOf(const Action* actions, const int32_t* index,
                                          const Params& p) {
  alignas(64) int32_t heading[kLanes], walk[kLanes], jump[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const Action& a = actions[index[lane]];
    heading[lane] = a.heading;
    walk[lane] = a.walk;
    jump[lane] = a.jump;
  }
  return {walkableHeading(load(heading), p), load(walk) != WideInt(0), load(jump) != WideInt(0)};
}

OBBY_LANES void putPlayer(Rows& rows, const WidePlayer& p) {
  putVector(rows, kPositionWord, p.position);
  putVector(rows, kVelocityWord, p.velocity);
  rows.word[kYawJumpsWord] = p.yaw | (p.jumps << 16);
  rows.word[kFloorlessHurtWord] =
      (rows.word[kFloorlessHurtWord] & int32_t(0xffff0000)) | p.floorlessSteps;
  rows.word[kStateWord] =
      (rows.word[kStateWord] & int32_t(0xff00ff00)) | p.landedSteps | (p.state << 16);
  rows.word[kFlagsWord] = (rows.word[kFlagsWord] & ~int32_t(kPlayerFlags)) |
                          select(p.sensed, WideInt(kFloorSensed), WideInt(0)) |
                          select(p.lifted, WideInt(kLegsLift), WideInt(0)) |
                          select(p.leftTruss, WideInt(kLeftTruss), WideInt(0));
}

// Returns the block of a collider's row.
OBBY_LANES geom::BlockT<WideFloat> blockOf(const Rows& rows) {
  static_assert(offsetof(level::Collider, pose) == 0 && offsetof(level::Collider, shape) == 48);
  return {{vectorAt(rows, 0), {vectorAt(rows, 3), vectorAt(rows, 6), vectorAt(rows, 9)}},
          vectorAt(rows, 12)};
}

// The motion of a world as a row.
struct alignas(64) MotionRow {
  float words[kRowWords];
};

// Converts motions to rows. `yaw` is the player's.
OBBY_LANES Rows rowsOf(const WideMotion& m, WideInt yaw) {
  // A body that the legs hold has no free steps, so this word encodes the legs as well.
  const WideFloat legs = select(m.drive.hangs, WideFloat(-2.0f), WideFloat(-1.0f));
  Rows r;
  putVector(r, 0, m.position);
  putVector(r, 3, m.velocity);
  putVector(r, 6, {m.drive.velocity.x, m.drive.velocity.z, m.drive.limit});
  putVector(r, 9, {m.drive.slide.x, m.drive.slide.z, m.bottom});
  putVector(r, 12, {select(m.drive.hover, legs, m.drive.freeSteps), m.floorY, m.floorSpeed});
  r.word[15] = yaw;
  return r;
}

// Returns the motions in these rows. `gravity` is the level's, because worlds with a running clock
// are never in lanes.
OBBY_LANES WideMotion motionAt(const Rows& r, float gravity) {
  const Vec3T<WideFloat> wanted = vectorAt(r, 6), slide = vectorAt(r, 9), legs = vectorAt(r, 12);
  DriveT<WideFloat> d;
  d.velocity = {wanted.x, 0, wanted.y};
  d.limit = wanted.z;
  d.slide = {slide.x, 0, slide.y};
  d.gravity = gravity;
  d.hover = legs.x < WideFloat(0.0f);
  d.hangs = legs.x == WideFloat(-2.0f);
  d.freeSteps = maxf(legs.x, WideFloat(0.0f));
  return {vectorAt(r, 0), vectorAt(r, 3), sinCosOf<WideFloat>(r.word[15]), slide.z, d,
          legs.y,         legs.z};
}

// Stores the result of a tick's motion in the player.
OBBY_LANES void putMoved(WidePlayer& player, const WideMotion& m) {
  player.position = m.position;
  player.velocity = m.velocity;
  player.lifted = legsLift(m.drive.hover, m.velocity.y, m.floorSpeed);
}

}  // namespace obby::sim
