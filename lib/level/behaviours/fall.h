// The way of a falling part, as a motion that its own clock drives.
#pragma once

#include "level/motion_tables.h"

namespace obby::level {

MotionTables fallTables(schema::Fall::Reader fall, const Pose& rest, const Params& params);

}  // namespace obby::level
