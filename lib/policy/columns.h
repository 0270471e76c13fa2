// The view of the ground. For each point of a rosette around the player it has the height of the
// highest floor in reach, and of the highest danger. Each is a maximum over parts, so their order
// has no effect. The templates take a number type (math/lanes.h), with a point in each lane.
#pragma once

#include "math/angle.h"
#include "policy/solid.h"

namespace obby::policy {

constexpr int kDirections = 12, kRings = 5;
constexpr int kPoints = 1 + kDirections * kRings;  // the first is under the feet
constexpr int kPaddedPoints = 64;

// Returns the radius of a ring, studs from the feet. Rings are dense where steps count, and sparse
// where jumps end.
OBBY_DEVICE float ringRadius(int ring) {
  return 1.5f + 1.5f * float(ring) + 0.35f * float(ring * ring);
}
constexpr float kSight = 14.2f;  // studs sideways; a little more than the last ring and kClearance

// Limits of heights, studs from the feet.
constexpr float kDeepest = -16, kHighest = 10;
// A player passes under parts that begin higher than this above the feet.
constexpr float kHeadroom = 7;

// Points of the ground, studs from the feet along the world's axes.
template <int kCount>
struct Points {
  float x[kCount], z[kCount];
};
using Rosette = Points<kPaddedPoints>;

// Returns direction `d` of the rosette. `ahead` is the first direction of each ring.
OBBY_DEVICE Vec3 rosetteDirection(Turns ahead, int d) {
  return directionOf(sinCos(Turns(ahead + d * 65536 / kDirections)));
}

OBBY_DEVICE void placePoints(Turns ahead, Rosette& r) {
  r.x[0] = r.z[0] = 0;
  for (int d = 0; d < kDirections; ++d) {
    const Vec3 direction = rosetteDirection(ahead, d);
    for (int ring = 0; ring < kRings; ++ring) {
      const int i = 1 + ring * kDirections + d;
      r.x[i] = direction.x * ringRadius(ring);
      r.z[i] = direction.z * ringRadius(ring);
    }
  }
  for (int i = kPoints; i < kPaddedPoints; ++i) r.x[i] = r.z[i] = 1e9f;
}

// Places a single point of the rosette, with the same bits as placePoints().
OBBY_DEVICE Points<1> placePoint(Turns ahead, int point) {
  if (point == 0) return {{0}, {0}};
  const Vec3 direction = rosetteDirection(ahead, (point - 1) % kDirections);
  const float radius = ringRadius((point - 1) / kDirections);
  return {{direction.x * radius}, {direction.z * radius}};
}

// Returns the height of the solid's top where it obstructs a player who walks or jumps there,
// otherwise kDeepest.
template <class F>
OBBY_DEVICE F heightAt(const Solid& solid, F x, F z) {
  const Stretch<F> in = cut<F>(solid, x, z);
  const MaskOf<F> met = (in.bottom <= in.top) & (in.bottom < F(kHeadroom));
  return select(met, minf(in.top, F(kHighest)), F(kDeepest));
}

// A point has two heights, that of the highest floor and that of the highest danger.
enum Kind : int { kFloor, kDanger, kKinds };

// The moments that a view shows: now, and shortly after.
constexpr int kMoments = 2;
constexpr float kSoon = 0.4f;  // seconds; about the length of a jump
using Moments = uint32_t;      // one bit each, the first is now
constexpr Moments kAlways = (1u << kMoments) - 1;

// A solid that a player can see.
struct Sight {
  Solid solid;
  Kind kind;
  Moments moments;          // moments in which it is there
  uint32_t collider = ~0u;  // index of a collider; ~0 for a region
};

// Dangers are widened to where they harm a player's centre.
constexpr float kClearance = 1;  // studs
OBBY_DEVICE Solid widened(Solid s) {
  const auto wide = [](Vec3 axis, float half) {
    return absf(axis.y) < 0.7f ? half + kClearance : half;
  };
  const Vec3 half = s.shape.half;
  s.shape.half = {wide(s.axes.x, half.x), wide(s.axes.y, half.y), wide(s.axes.z, half.z)};
  return s;
}

constexpr int kMaps = kMoments * kKinds;  // all kinds of one moment, then those of the next

// Hides a danger below a floor, because feet meet the floor first.
template <class F>
OBBY_DEVICE F uncovered(F danger, F floor) {
  return select(danger < floor, F(kDeepest), danger);
}

// The input for a height if nothing is there.
constexpr float kEmptyInput = 0;
// Returns the input for a height: its scaled difference from `before`, the height at the previous
// moment. The input is zero if nothing moves. At the first moment `before` is kDeepest, so the
// input is zero if nothing is there.
template <class F>
OBBY_DEVICE F shown(F height, F before) {
  return (height - before) * 0.125f;
}

// The maps of some points.
template <class F, int kCount>
struct Maps {
  static_assert(kCount % Lanes<F>::kCount == 0);
  alignas(64) float heights[kMoments][kKinds][kCount];

  OBBY_DEVICE Maps() {
    for (auto& moment : heights) {
      for (auto& kind : moment) {
        for (float& h : kind) h = kDeepest;
      }
    }
  }

  // Raises the heights of these moments to the solid's top where it obstructs a player who walks or
  // jumps there.
  OBBY_DEVICE void see(const Points<kCount>& points, const Sight& sight) {
    const Solid solid = sight.kind == kDanger ? widened(sight.solid) : sight.solid;
    for (int i = 0; i < kCount; i += Lanes<F>::kCount) {
      F x, z;
      loadRow(points.x + i, x);
      loadRow(points.z + i, z);
      const F height = heightAt<F>(solid, x, z);
      for (int m = 0; m < kMoments; ++m) {
        if (sight.moments >> m & 1) raise(heights[m][sight.kind] + i, height);
      }
    }
  }

  // Turns heights into inputs. Call it after the last call to see().
  OBBY_DEVICE void finish() {
    for (int i = 0; i < kCount; i += Lanes<F>::kCount) {
      F floorBefore(kDeepest), dangerBefore(kDeepest);
      for (auto& moment : heights) {
        F floor, danger;
        loadRow(moment[kFloor] + i, floor);
        loadRow(moment[kDanger] + i, danger);
        danger = uncovered(danger, floor);
        storeRow(shown(floor, floorBefore), moment[kFloor] + i);
        storeRow(shown(danger, dangerBefore), moment[kDanger] + i);
        floorBefore = floor;
        dangerBefore = danger;
      }
    }
  }

 private:
  OBBY_DEVICE static void raise(float* row, F height) {
    F old;
    loadRow(row, old);
    storeRow(maxf(old, height), row);
  }
};

}  // namespace obby::policy
