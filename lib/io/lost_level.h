// Levels that could not be read: a query that names none is of the level before it, and where that
// is lost it must not be taken for one of the level before that. Private to lib/io.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "io/record.h"

namespace obby::io {

// True if a record that could not be read, a line or the words of a message, was a level, or may
// have been one for all that it says of its kind.
bool mayBeLevel(std::string_view line);
bool mayBeLevel(const std::vector<uint64_t>& words);

// Whether a record belongs to a level and does not say to which, so that it is of the one before.
bool namesNoLevel(const Record& record);

}  // namespace obby::io
