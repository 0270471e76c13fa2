// Positions that the endless loop of a script gives to what drives a part, and the motion after
// them.
#pragma once

#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "import/roles/role.h"

namespace obby::importer {

// What a loop sets of a property of a constraint.
struct Steps {
  std::vector<const ScriptEvent*> events;
  double start = 0, period = 0;
};
// Of the first loop that sets one of the properties `names` and begins by itself.
std::optional<Steps> stepsOf(const RoleContext& context, InstanceId id,
                             std::initializer_list<const char*> names);

// Goals with the seconds into the round at which they are set.
using Goals = std::vector<std::pair<double, Pose>>;

// From each goal towards the next at `speed` (0: in kAlignSeconds), waiting in between as the steps
// do: a round that follows many others, the first of which began at `start`.
Motion stepped(const Pose& start, const Goals& goals, const Steps& steps, double speed);

}  // namespace obby::importer
