// How hard a solution is, as a record and as words.
#pragma once

#include <string>

#include "level/level.h"
#include "solve/report/difficulty/difficulty.h"

namespace obby::solve {

void fillDifficulty(schema::Difficulty::Builder record, const Difficulty& difficulty,
                    const NoiseModel& noise);

// "The hardest step is the jump from 'Post 2' to 'Post 3' (hard: its time window is 0.07 s)."
std::string hardestText(const Difficulty& difficulty, const level::Level& level,
                        schema::Level::Reader record);

}  // namespace obby::solve
