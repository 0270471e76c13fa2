#include "level/record_values.h"

#include <fmt/format.h>

namespace obby::level {

std::string shown(Vec3 v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); }

std::string shown(float number) { return fmt::format("{}", number); }

}  // namespace obby::level
