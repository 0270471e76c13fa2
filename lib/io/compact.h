// Copies long-lived records into no more memory than they need. A record that was read keeps its
// source text and spare capacity, which for a small record take twenty times its size.
#pragma once

#include <cstdint>

#include "io/record.h"

namespace obby::io {

// Returns the bytes of a compact copy, without the objects that hold it. `record` must be known().
uint64_t compactBytes(const Record& record);

// Returns a compact copy of the record, without a place in an input. `record` must be known().
Record compact(const Record& record);

}  // namespace obby::io
