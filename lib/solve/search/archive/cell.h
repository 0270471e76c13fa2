// Decides which states count as the same: maps a world to its cell of the archive. Dimensions other
// than position exist only if they matter in the level or the query.
#pragma once

#include <stdint.h>

#include "sim/rigid_body.h"
#include "sim/world.h"
#include "solve/search/archive/clock_view.h"

namespace obby::solve {

struct Binning {
  float inverseWidth = 1;       // 1 / cell width in studs, both horizontal axes
  float inverseHeight = 0.5f;   // 1 / cell height
  ClockView clock;              // tells where the level's clock matters
  uint32_t clockBin = 0;        // ticks per bin; 0: no clock dimension
  uint32_t healthBins = 0;      // bins of full health; 0: no health dimension
  float inverseHealth = 0.01f;  // 1 / full health
  bool jumps = false;           // the query limits jumps, or asks for some
  uint32_t maxJumps = 0xffff;   // jumps beyond this number make no difference
  bool waypoints = false;       // the query has waypoints
  bool clocks = false;          // parts start clocks when touched
  uint32_t bodyCount = 0;       // dynamic bodies, whose positions matter
  bool visits = false;          // the query has visits, in any order
  bool segmentJumps = false;    // the query limits the jumps of a segment
  uint32_t segmentBin = 0;      // ticks per bin of the time in a segment; 0: the query has no limit
  float inverseDamage = 0;      // bins per unit of health lost; 0: the query has no limit
};

constexpr uint32_t kMaxRunningBins = 16;  // the last bin, for clocks that run longer

OBBY_DEVICE int32_t floorToInt(float v) {
  const int32_t i = int32_t(v);
  return i - (float(i) > v ? 1 : 0);
}

// Spreads every bit over the whole word, one to one (the finaliser of SplitMix64).
OBBY_DEVICE uint64_t mixBits(uint64_t v) {
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}

// Returns the clock's bin, counted from 1; 0 where the clock does not matter. A period has about
// eight bins or more.
OBBY_DEVICE uint32_t clockBinOf(const Binning& b, const sim::World& w) {
  const uint32_t period = clockPeriodAt(b.clock, w.position);
  if (period == kNoClock) return 0;
  if (period == 0) return 1 + w.tick / b.clockBin;
  const uint32_t eighth = (period + 7) / 8;
  return 1 + (w.tick % period) / (eighth < b.clockBin ? eighth : b.clockBin);
}

// Returns a key of the running clocks that open or close routes, and of their age; 0 if none runs.
OBBY_DEVICE uint64_t runningKey(const Binning& b, const sim::World& w) {
  uint64_t key = 0;
  for (int i = 0; i < w.clockCount; ++i) {
    const sim::RunningClock& c = w.clocks[i];
    const uint32_t bin = b.clock.bins[c.clock];
    if (bin == 0) continue;
    const uint32_t at = c.ticks / bin;
    key += mixBits(uint64_t(c.clock) << 8 | (at < kMaxRunningBins ? at : kMaxRunningBins));
  }
  return key;
}

// Packs the cell of a position in units of cells. Exact for 8 million cells each way horizontally,
// and 32,000 vertically.
OBBY_DEVICE uint64_t packedCell(Vec3 at) {
  const uint64_t x = uint32_t(floorToInt(at.x)) & 0xffffffu;
  const uint64_t y = uint32_t(floorToInt(at.y)) & 0xffffu;
  const uint64_t z = uint32_t(floorToInt(at.z)) & 0xffffffu;
  return x | z << 24 | y << 48;
}

// Returns a key of the bodies' positions, in cells twice as wide as the player's. The cells of each
// body multiply the player's cells, so they are coarse.
OBBY_DEVICE uint64_t bodiesKey(const Binning& b, const sim::RigidBody* bodies) {
  uint64_t key = 0;
  for (uint32_t i = 0; i < b.bodyCount; ++i) {
    key = mixBits(key + 0x9e3779b97f4a7c15ull +
                  packedCell(bodies[i].position * (0.5f * b.inverseWidth)));
  }
  return key;
}

// Returns a key of the visits made and the limits used up; 0 if the query has neither.
OBBY_DEVICE uint64_t progressKey(const Binning& b, const sim::World& w) {
  uint64_t key = 0;
  if (b.visits) key = mixBits(w.visited);
  if (b.segmentJumps) key = mixBits(key + 1 + uint32_t(w.jumps - w.segmentJumps));
  if (b.segmentBin != 0) key = mixBits(key + 2 + (w.tick - w.segmentTick) / b.segmentBin);
  if (b.inverseDamage > 0) key = mixBits(key + 3 + uint64_t(w.damage * b.inverseDamage));
  return key;
}

// Returns the key of a world's cell, never 0. Positions are exact for 8 million cells each way, the
// other dimensions for 2^24 clock bins and 2^16 jumps. Two cells share a key with probability
// 2^-64.
OBBY_DEVICE uint64_t cellKey(const Binning& b, const sim::World& w,
                             const sim::RigidBody* bodies = nullptr) {
  const Vec3 inCells = mul(w.position, {b.inverseWidth, b.inverseHeight, b.inverseWidth});
  uint64_t rest = 0;
  if (b.clockBin != 0) rest = clockBinOf(b, w) & 0xffffffu;
  if (b.jumps) rest |= uint64_t(w.jumps < b.maxJumps ? w.jumps : b.maxJumps) << 24;
  if (b.waypoints) rest |= uint64_t(w.waypoints) << 40;
  if (b.clocks) rest |= uint64_t(w.clockCount) << 48;
  if (b.healthBins != 0) {
    rest |= uint64_t(w.health * b.inverseHealth * float(b.healthBins)) << 56;
  }
  if (b.bodyCount != 0) rest ^= bodiesKey(b, bodies);
  rest ^= progressKey(b, w);
  uint64_t key = mixBits(packedCell(inCells) + 0x9e3779b97f4a7c15ull * mixBits(rest + 1));
  if (b.clocks && w.clockCount != 0) key += runningKey(b, w);
  return key != 0 ? key : 1;
}

}  // namespace obby::solve
