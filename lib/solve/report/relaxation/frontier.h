// Finds parts that a search never stood on, nearest first: they may be too high or too far.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/report/relaxation/failure.h"

namespace obby::solve {

// Returns at most `count` parts that could be lowered, most promising first. For an unreachable
// query the part of the missing step comes first. The others are near a reached part and near a
// target.
std::vector<uint32_t> partsBeyond(const Failure& failure, size_t count);

}  // namespace obby::solve
