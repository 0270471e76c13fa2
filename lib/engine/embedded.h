// Holds the runtime's sources and the class table, which CMake embeds. Private to lib/engine.
#pragma once

#include <string_view>

namespace obby::engine {

// Returns an embedded file: "scheduler" is api/scheduler.luau, "classes.txt" the table. Returns ""
// if there is no such file.
std::string_view embeddedFile(std::string_view name);

}  // namespace obby::engine
