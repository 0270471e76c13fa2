// Where the simulator does not look at all parts: more are near a player there than one tick can
// hold (sim/candidates.h). Those left out are not there for that tick, so that a player can come
// into them, and nothing is known of what follows.
#pragma once

#include <vector>

#include "level/level_view.h"

namespace obby::solve {

// Boxes that hold the feet of all players of whom that is so, whatever their speed; some hundreds
// at most, however many the places are. Empty: it is so nowhere.
std::vector<Box> crowdedPlaces(const level::LevelView& level);

}  // namespace obby::solve
