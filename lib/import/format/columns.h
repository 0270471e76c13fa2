// Reads the number columns of the binary format. The bytes of an array are interleaved (all first
// bytes, then all second bytes, ...), most significant first. Each function returns `count` values,
// or none after failing the reader.
#pragma once

#include <cstdint>
#include <vector>

#include "import/format/byte_reader.h"

namespace obby::importer {

std::vector<uint32_t> readUint32Column(ByteReader& reader, size_t count);
// Reads zigzag-coded values: the sign is in the lowest bit.
std::vector<int32_t> readInt32Column(ByteReader& reader, size_t count);
std::vector<int64_t> readInt64Column(ByteReader& reader, size_t count);
// Reads IEEE single precision values with the sign bit moved to the lowest place.
std::vector<float> readFloatColumn(ByteReader& reader, size_t count);
// Reads referents. Each value is stored as the difference from the one before; -1 is null.
std::vector<int32_t> readReferentColumn(ByteReader& reader, size_t count);

}  // namespace obby::importer
