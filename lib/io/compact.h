// Records that are kept for long, in no more memory than they need. What was read has room to grow,
// of which a small record has twenty times what it takes, and the text that it came from.
#pragma once

#include <cstdint>

#include "io/record.h"

namespace obby::io {

// Bytes of what a compact copy of the record holds, without the objects that hold it. `record` is
// known().
uint64_t compactBytes(const Record& record);

// A copy with as much memory and no place in an input. `record` is known().
Record compact(const Record& record);

}  // namespace obby::io
