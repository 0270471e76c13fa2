// Writes the difficulty of a solution as a record and as text.
#pragma once

#include <string>

#include "level/level.h"
#include "solve/report/difficulty/difficulty.h"

namespace obby::solve {

void fillDifficulty(schema::Difficulty::Builder record, const Difficulty& difficulty,
                    const NoiseModel& noise);

// Returns text like "The hardest step is the jump from 'Post 2' to 'Post 3' (hard: its time window
// is 0.07 s)."
std::string hardestText(const Difficulty& difficulty, const level::Level& level,
                        schema::Level::Reader record);

}  // namespace obby::solve
