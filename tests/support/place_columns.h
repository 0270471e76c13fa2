// The property columns of the binary format, and the values that make up other blobs.
#pragma once

#include <string>
#include <vector>

#include "math/vec.h"
#include "support/file_values.h"

namespace obby::test {

using SharedStrings = std::vector<std::string>;

// Returns the column of a PROP chunk. Shared strings are looked up in `strings`, and added there.
std::string columnOf(FileKind kind, const std::vector<FileValue>& values, SharedStrings& strings);

// Appends little-endian values to `out`.
void append(std::string& out, uint32_t value);
void appendFloat(std::string& out, float value);
void appendDouble(std::string& out, double value);
void appendString(std::string& out, const std::string& value);
// Appends one byte for an axis-aligned rotation, otherwise a zero byte and nine floats.
void appendRotation(std::string& out, const Mat3& rotation);
// Appends a column of referents, as interleaved zigzag-coded differences.
void appendReferents(std::string& out, const std::vector<int32_t>& referents);

}  // namespace obby::test
