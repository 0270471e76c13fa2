// Which states count as the same: the cell of the archive that a world falls into. Dimensions
// beside position exist only where the level or the query makes them matter.
#pragma once

#include <stdint.h>

#include "sim/loose.h"
#include "sim/world.h"
#include "solve/search/archive/clock_view.h"

namespace obby::solve {

struct Binning {
  float inverseWidth = 1;       // 1 / cell width, studs, both sideways axes
  float inverseHeight = 0.5f;   // 1 / cell height
  ClockView clock;              // where the level's clock matters
  uint32_t clockBin = 0;        // ticks a bin; 0: no clock dimension
  uint32_t healthBins = 0;      // of full health; 0: no health dimension
  float inverseHealth = 0.01f;  // 1 / full health
  bool jumps = false;           // the query limits jumps, or asks for some
  uint32_t mostJumps = 0xffff;  // more than these make no difference
  bool waypoints = false;       // the query has waypoints
  bool clocks = false;          // parts start clocks when touched
  bool vanishing = false;       // parts vanish when touched
  uint32_t looseCount = 0;      // loose bodies: where each of them is
  bool visits = false;          // the query has visits, in any order
  bool segmentJumps = false;    // the query limits the jumps of a segment
  uint32_t segmentBin = 0;      // ticks a bin of the time in a segment; 0: the query has no limit
  float inverseDamage = 0;      // bins a unit of health lost; 0: the query has no limit
};

constexpr uint32_t kMostRunningBins = 16;  // after that a clock that goes on tells no more

OBBY_DEVICE int32_t floorToInt(float v) {
  const int32_t i = int32_t(v);
  return i - (float(i) > v ? 1 : 0);
}

// Spreads every bit over the whole word; one to one (the finaliser of SplitMix64).
OBBY_DEVICE uint64_t mixBits(uint64_t v) {
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}

// The clock's bin where the clock matters, counted from 1; 0 elsewhere. At least eight bins a
// period.
OBBY_DEVICE uint32_t clockBinOf(const Binning& b, const sim::World& w) {
  const uint32_t period = clockPeriodAt(b.clock, w.position);
  if (period == kNoClock) return 0;
  if (period == 0) return 1 + w.tick / b.clockBin;
  const uint32_t eighth = (period + 7) / 8;
  return 1 + (w.tick % period) / (eighth < b.clockBin ? eighth : b.clockBin);
}

// Which clocks run of those that open or close ways, and about for how long; 0: none of them.
OBBY_DEVICE uint64_t runningKey(const Binning& b, const sim::World& w) {
  uint64_t key = 0;
  for (int i = 0; i < w.clockCount; ++i) {
    const sim::RunningClock& c = w.clocks[i];
    const uint32_t bin = b.clock.bins[c.clock];
    if (bin == 0) continue;
    const uint32_t at = c.ticks / bin;
    key += mixBits(uint64_t(c.clock) << 8 | (at < kMostRunningBins ? at : kMostRunningBins));
  }
  return key;
}

// The cell of a position in units of cells; exact for 8 million cells each way (sideways), 32,000
// (up).
OBBY_DEVICE uint64_t packedCell(Vec3 at) {
  const uint64_t x = uint32_t(floorToInt(at.x)) & 0xffffffu;
  const uint64_t y = uint32_t(floorToInt(at.y)) & 0xffffu;
  const uint64_t z = uint32_t(floorToInt(at.z)) & 0xffffffu;
  return x | z << 24 | y << 48;
}

// Where the loose bodies are, in cells twice as wide as the player's: every cell of a body is one
// more of each cell of the player.
OBBY_DEVICE uint64_t looseKey(const Binning& b, const sim::LooseBody* loose) {
  uint64_t key = 0;
  for (uint32_t i = 0; i < b.looseCount; ++i) {
    key = mixBits(key + 0x9e3779b97f4a7c15ull +
                  packedCell(loose[i].position * (0.5f * b.inverseWidth)));
  }
  return key;
}

// What the limits and visits of a query make of a state; 0 where it has none.
OBBY_DEVICE uint64_t progressKey(const Binning& b, const sim::World& w) {
  uint64_t key = 0;
  if (b.visits) key = mixBits(w.visited);
  if (b.segmentJumps) key = mixBits(key + 1 + uint32_t(w.jumps - w.segmentJumps));
  if (b.segmentBin != 0) key = mixBits(key + 2 + (w.tick - w.segmentTick) / b.segmentBin);
  if (b.inverseDamage > 0) key = mixBits(key + 3 + uint64_t(w.damage * b.inverseDamage));
  return key;
}

// Never 0. Positions are exact for 8 million cells each way, the other dimensions for 2^24 clock
// bins and 2^16 jumps; two cells share a key with probability 2^-64.
OBBY_DEVICE uint64_t cellKey(const Binning& b, const sim::World& w,
                             const sim::LooseBody* loose = nullptr) {
  const Vec3 inCells = mul(w.position, {b.inverseWidth, b.inverseHeight, b.inverseWidth});
  uint64_t rest = 0;
  if (b.clockBin != 0) rest = clockBinOf(b, w) & 0xffffffu;
  if (b.jumps) rest |= uint64_t(w.jumps < b.mostJumps ? w.jumps : b.mostJumps) << 24;
  if (b.waypoints) rest |= uint64_t(w.waypoints) << 40;
  if (b.clocks) rest |= uint64_t(w.clockCount) << 48;
  if (b.healthBins != 0) {
    rest |= uint64_t(w.health * b.inverseHealth * float(b.healthBins)) << 56;
  }
  if (b.looseCount != 0) rest ^= looseKey(b, loose);
  rest ^= progressKey(b, w);
  uint64_t key = mixBits(packedCell(inCells) + 0x9e3779b97f4a7c15ull * mixBits(rest + 1));
  if (b.clocks && w.clockCount != 0) key += runningKey(b, w);
  return key != 0 ? key : 1;
}

}  // namespace obby::solve
