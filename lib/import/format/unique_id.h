// Writes UniqueIds as text, the same from both formats.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace obby::importer {

// Returns 32 hexadecimal digits in the order of the XML format: random, time, index. `bytes` has
// the binary format's order, most significant first: index (u32), time (u32), random (64 bits with
// the sign in the lowest place).
std::string uniqueIdText(const std::array<uint8_t, 16>& bytes);

}  // namespace obby::importer
