// The calibration course: ground, ice of two frictions, ledges, a wall, a truss, gaps, steps,
// ramps, a belt, a ferry and a box to push. A floor lies below every drop, so that no player dies.
#pragma once

#include "schema/obby.capnp.h"

namespace obby::calibrate {

constexpr const char* kCourseName = "calibration";

void writeCourse(schema::Level::Builder level);

}  // namespace obby::calibrate
