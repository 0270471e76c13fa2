// Reads streams of Cap'n Proto messages. The first byte selects whether the rest is the segment of
// one message (after a valid table) or a whole stream, packed or not.
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "stream_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 1) {
    bytes.resize(bytes.size() / 8 * 8);
    const uint32_t table[2] = {0, uint32_t(bytes.size() / 8)};
    bytes.insert(0, reinterpret_cast<const char*>(table), 8);
  }
  obby::fuzz::checkStream(std::move(bytes));
  return 0;
}
