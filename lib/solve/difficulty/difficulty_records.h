// How hard a solution is, as a record and as words.
#pragma once

#include <string>

#include "level/level.h"
#include "solve/difficulty/difficulty.h"

namespace obby::solve {

void fillDifficulty(schema::Difficulty::Builder record, const Difficulty& difficulty,
                    const NoiseModel& noise);

// "the jump from part 3 'Post 2' to part 4 'Post 3' (hard, window 67 ms)"
std::string hardestText(const Difficulty& difficulty, const level::Level& level);

}  // namespace obby::solve
