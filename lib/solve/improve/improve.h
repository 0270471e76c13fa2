// Makes a solution better by a preference: cuts corners, drops and shifts jumps, simplifies keys,
// and searches again under tighter limits. Every change is played in the simulator.
#pragma once

#include "solve/improve/improve_task.h"
#include "solve/search/method.h"

namespace obby::solve {

// Changes the solution until the budget is spent. Never returns a dearer one.
Improved improve(const ImproveTask& task, const Trajectory& solution);

// Does the same, and also lets `method` search for other solutions, some with fewer jumps or in
// less time, of which the best spans are taken.
Improved improveWidely(const ImproveTask& task, const Trajectory& solution, const Method& method,
                       const Machine& machine);

}  // namespace obby::solve
