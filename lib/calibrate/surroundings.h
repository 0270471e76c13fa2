// What a recording shows beside its player: which tick of the level's clock it begins at, and where
// loose bodies are.
#pragma once

#include <string>
#include <vector>

#include "calibrate/track.h"
#include "level/level.h"
#include "sim/loose.h"

namespace obby::calibrate {

constexpr uint32_t kLongestClock = 120;  // seconds of the level's clock that are tried

// Finds the recorded parts in the level, and the level clock at the first frame: the tick from
// which moving parts of the level come nearest to where the recording has them. Errors: a part that
// the level has not, or has more than once.
Status place(Track& track, schema::Level::Reader record, const level::Level& level);

// A moving part that does not move as the level says.
struct Stray {
  std::string part;  // as the recording names it
  uint32_t number;   // in the level
  float studs;       // off, the root of the mean square
};
std::vector<Stray> straysOf(const Track& track, const level::LevelView& level);

// Each loose body is recorded, or the player stays far from it: the simulator can begin at any
// frame.
bool showsLoose(const Track& track, const level::LevelView& level);

// Puts the recorded loose bodies where the frame has them, as fast as they are then. True if one
// moves.
bool showLoose(const Track& track, uint32_t frame, const level::LevelView& level,
               std::vector<sim::LooseBody>& bodies);

}  // namespace obby::calibrate
