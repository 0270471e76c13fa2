// Worlds as lanes: the player's part of kLanes worlds from and to their rows, and the motions of a
// block of worlds as arrays, so that any of them can be put into lanes together.
#pragma once

#include <stddef.h>

#include <bit>

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

// The block of a collider's row.
OBBY_LANES geom::BlockT<WideFloat> blockOf(const Rows& rows) {
  static_assert(offsetof(level::Collider, pose) == 0 && offsetof(level::Collider, shape) == 48);
  return {{vectorAt(rows, 0), {vectorAt(rows, 3), vectorAt(rows, 6), vectorAt(rows, 9)}},
          vectorAt(rows, 12)};
}

// Motions of up to `kSlots` worlds, a row a field.
template <int kSlots>
class MotionTable {
 public:
  void put(int firstSlot, const WideMotion& m) {
    WideMotion copy = m;
    // Legs that hold the body leave no step free.
    const WideFloat legs = select(m.drive.hangs, WideFloat(kHangs), WideFloat(kHovers));
    copy.drive.freeSteps = select(m.drive.hover, legs, m.drive.freeSteps);
    int row = 0;
    forFields(copy, [&](WideFloat& field) { store(field, rows_[row++] + firstSlot); });
  }
  WideMotion take(const int32_t* slots) const {
    WideMotion m;
    int row = 0;
    forFields(m, [&](WideFloat& field) { field = obby::gather(rows_[row++], slots); });
    m.drive.hover = m.drive.freeSteps < WideFloat(0.0f);
    m.drive.hangs = m.drive.freeSteps == WideFloat(kHangs);
    m.drive.freeSteps = maxf(m.drive.freeSteps, WideFloat(0.0f));
    return m;
  }
  void putMoved(const int32_t* slots, const WideMotion& m) {
    const Vec3T<WideFloat> moved[2] = {m.position, m.velocity};
    for (int i = 0; i < 2; ++i) {
      scatter(moved[i].x, rows_[3 * i], slots);
      scatter(moved[i].y, rows_[3 * i + 1], slots);
      scatter(moved[i].z, rows_[3 * i + 2], slots);
    }
  }
  Vec3T<WideFloat> position(int firstSlot) const { return vector(0, firstSlot); }
  Vec3T<WideFloat> velocity(int firstSlot) const { return vector(3, firstSlot); }
  WideMask lifts(int firstSlot) const {
    const auto at = [&](int row) { return load(rows_[row] + firstSlot); };
    return legsLift(at(kHoverRow) < WideFloat(0.0f), at(4), at(kFloorSpeedRow));
  }

 private:
  static constexpr int kFields = 17, kHoverRow = 14, kFloorSpeedRow = 16;
  static constexpr float kHovers = -1, kHangs = -2;  // in place of freeSteps

  // Position and velocity are the first six.
  template <class Each>
  static OBBY_LANES void forFields(WideMotion& m, Each&& each) {
    for (Vec3T<WideFloat>* v : {&m.position, &m.velocity}) each(v->x), each(v->y), each(v->z);
    each(m.yaw.sin), each(m.yaw.cos), each(m.bottom);
    each(m.drive.velocity.x), each(m.drive.velocity.z), each(m.drive.limit);
    each(m.drive.slide.x), each(m.drive.slide.z), each(m.drive.freeSteps);
    each(m.floorY), each(m.floorSpeed);
  }
  Vec3T<WideFloat> vector(int row, int slot) const {
    return {load(rows_[row] + slot), load(rows_[row + 1] + slot), load(rows_[row + 2] + slot)};
  }

  alignas(64) float rows_[kFields][kSlots];
};

}  // namespace obby::sim
