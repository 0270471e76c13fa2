// The runtime's sources and the class table, which CMake puts into the program.
// Private to lib/engine.
#pragma once

#include <string_view>

namespace obby::engine {

// "scheduler" gives api/scheduler.luau, "classes.txt" the table; empty if there is no such file.
std::string_view embeddedFile(std::string_view name);

}  // namespace obby::engine
