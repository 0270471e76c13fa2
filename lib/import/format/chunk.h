// The chunks of the binary format: where they are, and their content decompressed.
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
  size_t offset = 0;      // of the chunk's header in the file
  std::string_view body;  // as in the file: stored, LZ4 or zstd
  bool compressed = false;
  uint32_t rawLength = 0;
};

// Decompressed bytes; they own their memory only if something had to be decompressed.
struct ChunkData {
  std::string_view bytes;
  std::unique_ptr<char[]> owned;
};

// The chunks from `firstOffset` to the END chunk, which is the last one. Nothing is decompressed.
Result<std::vector<Chunk>> listChunks(std::string_view file, size_t firstOffset);

// `fileSize` bounds what a chunk may grow to: at most 256 MiB, and not much more than the file; and
// what all may: `total`, 0 before the first, counts their bytes.
Result<ChunkData> decompress(const Chunk& chunk, size_t fileSize, size_t& total);

// An Error at the chunk's place: "byte 4711: PROP".
Error chunkError(const Chunk& chunk, std::string message);

}  // namespace obby::importer
