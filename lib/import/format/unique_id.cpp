// Converts UniqueIds. The binary format rotates the random part left by one bit; XML does not.
#include "import/format/unique_id.h"

namespace obby::importer {
namespace {

constexpr char kHex[] = "0123456789abcdef";

void appendByte(std::string& out, uint8_t byte) {
  out += kHex[byte >> 4];
  out += kHex[byte & 15];
}

}  // namespace

std::string uniqueIdText(const std::array<uint8_t, 16>& bytes) {
  uint64_t random = 0;
  for (size_t i = 8; i < 16; ++i) random = (random << 8) | bytes[i];
  random = (random >> 1) | (random << 63);
  std::string out;
  out.reserve(32);
  for (int shift = 56; shift >= 0; shift -= 8)
    appendByte(out, static_cast<uint8_t>(random >> shift));
  for (size_t i = 4; i < 8; ++i) appendByte(out, bytes[i]);
  for (size_t i = 0; i < 4; ++i) appendByte(out, bytes[i]);
  return out;
}

}  // namespace obby::importer
