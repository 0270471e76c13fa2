// Decodes the 24 axis-aligned rotations that files shorten to one byte, and rotations given as nine
// numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "math/vec.h"

namespace obby::importer {

// Returns nullopt for ids that name no rotation. That includes id 0, which stands for nine numbers.
std::optional<Mat3> rotationFromId(uint8_t id);

// Builds the matrix from R00 R01 R02 R10 ... R22, row by row. Its columns are the axes.
Mat3 rotationFromRows(const std::array<float, 9>& rows);

}  // namespace obby::importer
