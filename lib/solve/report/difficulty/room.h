// How much room a recorded playthrough leaves: to the edge of what it lands on, and to what kills.
#pragma once

#include "solve/model/route.h"

namespace obby::solve {

constexpr float kLookForKills = 10;  // studs

// Studs from the feet at `tick` of the course to the nearest edge of the upper face of `part`;
// negative: so far beyond it. Of the part's bounding box (of one with several hulls, the best of
// theirs), which is generous for balls, cylinders and hulls.
float landingMargin(const level::LevelView& level, const Course& course, uint32_t tick,
                    int32_t part);

// Studs from the limbs, which are what is killed, to the nearest kill part, at least, in all ticks
// of the segment; -1: none within kLookForKills. A lower bound for cylinders, exact for the others.
float killClearance(const level::LevelView& level, const Course& course, const Segment& segment);

}  // namespace obby::solve
