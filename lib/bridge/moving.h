// The parts of a level that may move or change, usually few in a large place.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::bridge {

// Returns level records, one per line, with `{}` for every part that is anchored and neither moves
// nor vanishes. All parts thus keep their indices. A line that is not JSON is an error.
Result<std::string> movingParts(std::string_view lines);

}  // namespace obby::bridge
