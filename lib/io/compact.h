// Long-lived records in no more memory than they need. A record that was read has spare capacity,
// for a small one twenty times its size, and keeps its source text.
#pragma once

#include <cstdint>

#include "io/record.h"

namespace obby::io {

// Returns the bytes of a compact copy, without the objects that hold it. `record` must be known().
uint64_t compactBytes(const Record& record);

// Returns a copy of that size, without a place in an input. `record` must be known().
Record compact(const Record& record);

}  // namespace obby::io
