// Where loose parts are during a playthrough: what the player pushes, and what falls by itself.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"
#include "sim/simulator.h"
#include "view/poses.h"

namespace obby::view {

// Poses of one part at some ticks. Between two of them, and all of the way, the part is where a
// straight line and an even turn from one to the next would have it, to kLooseMiss.
struct LooseTrack : Poses {
  uint32_t part = 0;
  std::vector<uint32_t> ticks;  // of the samples, since the start of the playthrough; ascending

  size_t bytes() const { return Poses::bytes() + ticks.size() * 4; }
};
constexpr float kLooseMiss = 2.5e-4f;  // studs, of any point of the part

// One track for each part that moves by more than that.
std::vector<LooseTrack> looseTracksOf(const sim::Replay& replay, const level::LevelView& level);

}  // namespace obby::view
