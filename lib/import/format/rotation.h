// The 24 axis-aligned rotations that files shorten to one byte, and rotations given as nine
// numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "math/vec.h"

namespace obby::importer {

// Nothing for ids that name no rotation. Id 0 stands for nine numbers and is none, either.
std::optional<Mat3> rotationFromId(uint8_t id);

// R00 R01 R02 R10 ... R22, row by row; the columns are the axes.
Mat3 rotationFromRows(const std::array<float, 9>& rows);

}  // namespace obby::importer
