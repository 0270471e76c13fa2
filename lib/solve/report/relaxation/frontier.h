// Parts that a search never stood on, the nearest beyond where it has been first: the ones that may
// be too high or too far.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/report/relaxation/failure.h"

namespace obby::solve {

// At most `count` parts that could be lowered, most promising first: of an unreachable query the
// one that the missing step leads to, what the query's places stand on, then the nearest beyond.
std::vector<uint32_t> partsBeyond(const Failure& failure, size_t count);

}  // namespace obby::solve
