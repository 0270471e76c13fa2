// Measures a recorded trajectory's clearance to the edges of the parts it lands on, and to kill
// parts.
#pragma once

#include "solve/model/route.h"

namespace obby::solve {

constexpr float kLookForKills = 10;  // studs

// Returns the studs from the feet at `tick` of the course to the nearest edge of the upper face of
// `part`; negative beyond it. The face is that of the part's bounding box, or the best of its
// hulls' boxes. This is generous for balls, cylinders and hulls.
float landingMargin(const level::LevelView& level, const Course& course, uint32_t tick,
                    int32_t part);

// Returns the min distance in studs from a kill part to the limbs that it tests, over all ticks of
// the segment; -1 if no kill part is within kLookForKills. It is a lower bound for cylinders, and
// exact for other shapes.
float killClearance(const level::LevelView& level, const Course& course, const Segment& segment);

}  // namespace obby::solve
