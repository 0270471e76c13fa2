// Trajectories as a model for Roblox Studio: a Model for each query, and in it a Model for each
// trajectory. They consist of thin glowing parts, with a ball at each jump and a block at the death
// of an attempt. All parts are anchored and do not collide.
#pragma once

#include <string>

#include "view/report.h"

namespace obby::view {

// Returns the bytes of an rbxmx file. Queries without trajectories are left out.
std::string trajectoriesModel(const Report& report);

}  // namespace obby::view
