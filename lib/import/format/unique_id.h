// UniqueIds as text, the same from both formats.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace obby::importer {

// `bytes`: index (u32), time (u32), random (64 bits with the sign in the lowest place), all most
// significant first, as in the binary format. The text is 32 hexadecimal digits in the order of the
// XML format: random, time, index.
std::string uniqueIdText(const std::array<uint8_t, 16>& bytes);

}  // namespace obby::importer
