// What of a level may not be where, or as, the level has it at rest: a small part of a large place.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::bridge {

// Level records, a line each, with `{}` for every part that is anchored and neither moves nor
// vanishes, so that all parts keep their places in the list. Error: a line is no JSON.
Result<std::string> movingParts(std::string_view lines);

}  // namespace obby::bridge
