// Lists the chunks of the binary format and decompresses their content.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace obby::importer {

struct Chunk {
  std::string name;       // up to 4 letters, without padding
  size_t offset = 0;      // offset of the chunk's header in the file
  std::string_view body;  // bytes in the file: stored, LZ4 or zstd
  bool compressed = false;
  uint32_t rawLength = 0;
};

// Decompressed bytes. They own memory only if decompression was necessary.
struct ChunkData {
  std::string_view bytes;
  std::unique_ptr<char[]> owned;
};

// Lists the chunks from `firstOffset` to the END chunk, which is the last one, without
// decompressing.
Result<std::vector<Chunk>> listChunks(std::string_view file, size_t firstOffset);

// Decompresses one chunk. A chunk may grow to 256 MiB, and to no more than 16 MiB plus 16 times
// `fileSize`. `total`, 0 before the first chunk, sums the bytes of all chunks and is bounded, too.
Result<ChunkData> decompress(const Chunk& chunk, size_t fileSize, size_t& total);

// Returns the error of a damaged file, at the chunk's place: "byte 4711: PROP".
Error chunkError(const Chunk& chunk, std::string message);

}  // namespace obby::importer
