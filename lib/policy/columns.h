// The view of the ground: on a rosette of points around the player, how high the highest floor in
// reach is, and how high what kills. A maximum over parts, so that their order does not show.
// Templates on the number type (math/lanes.h): a point a lane.
#pragma once

#include "geom/shape.h"
#include "math/angle.h"
#include "math/lanes.h"

namespace obby::policy {

constexpr int kDirections = 12, kRings = 5;
constexpr int kPoints = 1 + kDirections * kRings;  // the first is under the feet
constexpr int kPaddedPoints = 64;

// Studs from the feet: close where a step counts, wide where a jump ends.
OBBY_DEVICE float ringRadius(int ring) {
  return 1.5f + 1.5f * float(ring) + 0.35f * float(ring * ring);
}
constexpr float kSight = 13.2f;  // studs sideways: a little more than the last ring

// Heights are studs from the feet, and end here.
constexpr float kDeepest = -16, kHighest = 10;
// What begins higher than this above the feet is passed under.
constexpr float kHeadroom = 7;

// Points of the rosette, studs from the feet in the world's axes.
struct Rosette {
  float x[kPaddedPoints], z[kPaddedPoints];
};

// Direction `d` of the rosette; `ahead`: the first one, of each ring.
OBBY_DEVICE Vec3 rosetteDirection(Turns ahead, int d) {
  return directionOf(sinCos(Turns(ahead + d * 65536 / kDirections)));
}

OBBY_DEVICE void placePoints(Turns ahead, Rosette& r) {
  r.x[0] = r.z[0] = 0;
  for (int d = 0; d < kDirections; ++d) {
    const Vec3 way = rosetteDirection(ahead, d);
    for (int ring = 0; ring < kRings; ++ring) {
      const int i = 1 + ring * kDirections + d;
      r.x[i] = way.x * ringRadius(ring);
      r.z[i] = way.z * ringRadius(ring);
    }
  }
  for (int i = kPoints; i < kPaddedPoints; ++i) r.x[i] = r.z[i] = 1e9f;
}

// A box or a wedge, as vertical lines cut it. Balls, cylinders and hulls are seen as the boxes
// around them.
struct Solid {
  Vec3 center;  // from the feet
  Mat3 axes;
  Vec3 half;
  bool wedge;
};

// Lowest and highest point of the solid on the vertical line through (x, z); bottom > top where it
// misses.
template <class F>
OBBY_DEVICE void cut(const Solid& s, F x, F z, F& bottom, F& top) {
  const F dx = x - s.center.x, dz = z - s.center.z;
  const float dy = -s.center.y;
  bottom = F(-1e9f);
  top = F(1e9f);
  const auto slab = [&](Vec3 axis, float half) OBBY_INLINED {
    const F o = (dx * axis.x + dy * axis.y) + dz * axis.z;
    const float inverse = 1.0f / geom::awayFromZero(axis.y);
    const F a = (-half - o) * inverse, b = (half - o) * inverse;
    bottom = maxf(bottom, minf(a, b));
    top = minf(top, maxf(a, b));
  };
  slab(s.axes.x, s.half.x);
  slab(s.axes.y, s.half.y);
  slab(s.axes.z, s.half.z);
  if (!s.wedge) return;
  // Inside: local y * half.z <= z * half.y.
  const Vec3 normal = s.axes.y * s.half.z - s.axes.z * s.half.y;
  const F o = (dx * normal.x + dy * normal.y) + dz * normal.z;
  const float inverse = 1.0f / geom::awayFromZero(normal.y);
  const F at = -o * inverse;
  if (normal.y > 0) {
    top = minf(top, at);
  } else {
    bottom = maxf(bottom, at);
  }
}

// Lanes of a row: the one lane of a float. WideFloat has its own (policy.cpp).
OBBY_DEVICE void loadRow(const float* from, float& row) { row = *from; }
OBBY_DEVICE void storeRow(float row, float* to) { *to = row; }
OBBY_DEVICE uint32_t laneBits(bool m) { return m ? 1 : 0; }

// Height of the solid's top where it is in the way of somebody who walks or jumps there, elsewhere
// kDeepest. False: it is so nowhere.
template <class F>
OBBY_DEVICE bool heightAt(const Solid& solid, F x, F z, F& height) {
  F bottom, top;
  cut<F>(solid, x, z, bottom, top);
  const MaskOf<F> met = (bottom <= top) & (bottom < F(kHeadroom));
  if (!any(met)) return false;
  height = select(met, minf(top, F(kHighest)), F(kDeepest));
  return true;
}

constexpr int kMaps = 4;  // floor, danger; the same soon

// Heights of the rosette's points.
template <class F>
struct Maps {
  alignas(64) float heights[kMaps][kPaddedPoints];

  OBBY_DEVICE Maps() {
    for (auto& map : heights) {
      for (float& h : map) h = kDeepest;
    }
  }

  // Raises the maps of `now` and `soon` to the solid's top where it is in the way of somebody who
  // walks or jumps there.
  OBBY_DEVICE void see(const Rosette& rosette, const Solid& solid, bool danger, bool now,
                       bool soon) {
    const int map = danger ? 1 : 0;
    for (int i = 0; i < kPaddedPoints; i += Lanes<F>::kCount) {
      F x, z, height;
      loadRow(rosette.x + i, x);
      loadRow(rosette.z + i, z);
      if (!heightAt<F>(solid, x, z, height)) continue;
      if (now) raise(heights[map] + i, height);
      if (soon) raise(heights[map + 2] + i, height);
    }
  }

 private:
  OBBY_DEVICE static void raise(float* row, F height) {
    F old;
    loadRow(row, old);
    storeRow(maxf(old, height), row);
  }
};

// The heights of one point of the rosette.
struct PointMaps {
  float x = 0, z = 0;
  float heights[kMaps] = {kDeepest, kDeepest, kDeepest, kDeepest};

  OBBY_DEVICE PointMaps(Turns ahead, int point) {
    if (point == 0) return;
    const int ring = (point - 1) / kDirections;
    const Vec3 way = rosetteDirection(ahead, (point - 1) % kDirections);
    x = way.x * ringRadius(ring);
    z = way.z * ringRadius(ring);
  }

  // As Maps::see.
  OBBY_DEVICE void see(const Solid& solid, bool danger, bool now, bool soon) {
    float height;
    if (!heightAt<float>(solid, x, z, height)) return;
    const auto raise = [&](bool seen, float& floor, float& harm) {
      if (!seen) return;
      float& old = danger ? harm : floor;
      old = maxf(old, height);
    };
    raise(now, heights[0], heights[1]);
    raise(soon, heights[2], heights[3]);
  }
};

}  // namespace obby::policy
