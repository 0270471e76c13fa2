// Detects levels that could not be read. A query that names no level belongs to the level before
// it. If that level is lost, the query must not be used with an earlier level. Private to lib/io.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "io/record.h"

namespace obby::io {

// Both return true if a record that could not be read was a level, or may have been one. The
// argument is a line, or the words of a message.
bool mayBeLevel(std::string_view line);
bool mayBeLevel(const std::vector<uint64_t>& words);

// Returns true if a record belongs to a level without naming it, and so to the level before it.
bool namesNoLevel(const Record& record);

}  // namespace obby::io
