// Compiled once for each CPU level, with OBBY_LANE_TABLE as the name of that level's table.
#include "sim/lane_table.h"

extern "C" const obby::sim::LaneTable OBBY_LANE_TABLE;
const obby::sim::LaneTable OBBY_LANE_TABLE = {&obby::sim::tick<true>, &obby::sim::tick<false>,
                                              &obby::sim::tickAll};
