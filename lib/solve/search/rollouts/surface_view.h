// The places where a player could stand, as rollouts look them up. For host and device.
#pragma once

#include <stdint.h>

#include "base/random.h"
#include "sim/clocks.h"

namespace obby::solve {

struct SurfacePoint {
  Vec3 position;   // in the world, or in the frame of the mover
  uint32_t mover;  // index into LevelView::movers, or level::kNone
};

// Returns the position of the point at the time of a world.
OBBY_DEVICE Vec3 positionIn(const level::LevelView& level, const SurfacePoint& p,
                            const sim::World& w) {
  return p.mover == level::kNone ? p.position
                                 : toWorld(poseOf(level.movers[p.mover], w, 0), p.position);
}

// Plain spans, for device code. Cells are in order of layer (Y), row (Z), column (X), so that the
// points of neighbouring columns are contiguous.
struct SurfaceView {
  const SurfacePoint* points;
  const uint32_t* entries;  // (starts[last]), indices into points; moving points are in many cells
  const uint32_t* starts;   // (nx * ny * nz + 1), into entries
  Vec3 origin;
  float inverseWidth, inverseHeight;  // 1 / cell extents
  int32_t nx, ny, nz;
  uint32_t pointCount;
};

template <class Table>
OBBY_DEVICE void forTables(SurfaceView& s, Table&& table) {
  const size_t cells = size_t(s.nx) * s.ny * s.nz;
  table(s.points, s.pointCount);
  table(s.entries, s.starts[cells]);
  table(s.starts, cells + 1);
}

// Draws a point near `from`, uniformly from the grid cells within `radius` studs sideways and
// between `drop` below and `rise` above. Returns its index into points, or level::kNone if there is
// none.
OBBY_DEVICE uint32_t pickPoint(const SurfaceView& s, Vec3 from, float radius, float drop,
                               float rise, Random& random) {
  const auto cell = [](float v, float origin, float inverse, int32_t n) {
    const float c = (v - origin) * inverse;
    return c <= 0 ? 0 : (c >= float(n - 1) ? n - 1 : int32_t(c));
  };
  const int32_t x0 = cell(from.x - radius, s.origin.x, s.inverseWidth, s.nx);
  const int32_t x1 = cell(from.x + radius, s.origin.x, s.inverseWidth, s.nx);
  const int32_t z0 = cell(from.z - radius, s.origin.z, s.inverseWidth, s.nz);
  const int32_t z1 = cell(from.z + radius, s.origin.z, s.inverseWidth, s.nz);
  const int32_t y0 = cell(from.y - drop, s.origin.y, s.inverseHeight, s.ny);
  const int32_t y1 = cell(from.y + rise, s.origin.y, s.inverseHeight, s.ny);
  uint32_t total = 0;
  for (int32_t y = y0; y <= y1; ++y) {
    for (int32_t z = z0; z <= z1; ++z) {
      const uint32_t* row = s.starts + (size_t(y) * s.nz + z) * s.nx;
      total += row[x1 + 1] - row[x0];
    }
  }
  if (total == 0) return level::kNone;
  uint32_t rest = random.below(total);
  for (int32_t y = y0; y <= y1; ++y) {
    for (int32_t z = z0; z <= z1; ++z) {
      const uint32_t* row = s.starts + (size_t(y) * s.nz + z) * s.nx;
      const uint32_t count = row[x1 + 1] - row[x0];
      if (rest < count) return s.entries[row[x0] + rest];
      rest -= count;
    }
  }
  return level::kNone;
}

}  // namespace obby::solve
