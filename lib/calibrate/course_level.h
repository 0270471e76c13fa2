// The calibration course: ground, ice of two frictions, ledges, a wall, a truss, gaps, steps,
// ramps, a belt, a ferry and a box to push. Below what can be fallen from is a floor: nobody dies.
#pragma once

#include "schema/obby.capnp.h"

namespace obby::calibrate {

constexpr const char* kCourseName = "calibration";

void writeCourse(schema::Level::Builder level);

}  // namespace obby::calibrate
