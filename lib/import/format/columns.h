// The number columns of the binary format: the bytes of an array are interleaved (all first bytes,
// then all second bytes, ...), most significant first. Each function returns `count` values, or
// none after failing the reader.
#pragma once

#include <cstdint>
#include <vector>

#include "import/format/byte_reader.h"

namespace obby::importer {

std::vector<uint32_t> readUint32Column(ByteReader& reader, size_t count);
// Zigzag: the sign is in the lowest bit.
std::vector<int32_t> readInt32Column(ByteReader& reader, size_t count);
std::vector<int64_t> readInt64Column(ByteReader& reader, size_t count);
// IEEE single precision with the sign bit moved to the lowest place.
std::vector<float> readFloatColumn(ByteReader& reader, size_t count);
// Each value is the difference to the one before; -1 is null.
std::vector<int32_t> readReferentColumn(ByteReader& reader, size_t count);

}  // namespace obby::importer
