// Compiled once for each CPU level, with OBBY_LANE_TABLE as the name of that level's table.
#include "policy/lane_table.h"

extern "C" const obby::policy::LaneTable OBBY_LANE_TABLE;
const obby::policy::LaneTable OBBY_LANE_TABLE = {&obby::policy::observe, &obby::policy::observe,
                                                 &obby::policy::think, &obby::policy::decide,
                                                 &obby::policy::decideOn};
