// Trajectories as a model that Roblox Studio opens: a Model for each query, in it one for each way,
// of thin glowing parts with a ball at each jump and a block where an attempt died. They are
// anchored and nothing meets them.
#pragma once

#include <string>

#include "view/report.h"

namespace obby::view {

// The bytes of an rbxmx file. Queries without trajectories are left out.
std::string waysModel(const Report& report);

}  // namespace obby::view
