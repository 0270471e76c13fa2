// Decompression of one chunk. The input is the claimed length, followed by the chunk's body.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "import/format/chunk.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace obby::importer;
  if (size < 4) return 0;
  Chunk chunk;
  chunk.name = "PROP";
  chunk.compressed = true;
  std::memcpy(&chunk.rawLength, data, 4);
  chunk.body = std::string_view(reinterpret_cast<const char*>(data) + 4, size - 4);
  size_t total = 0;
  const auto raw = decompress(chunk, size, total);
  if (raw && raw->bytes.size() != chunk.rawLength) __builtin_trap();
  return 0;
}
