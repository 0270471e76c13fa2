// Reads a chunk: name, compressed length (0: stored), raw length, 4 unused bytes, body. zstd bodies
// begin with zstd's magic number; all others are bare LZ4 blocks.
#include "import/format/chunk.h"

#include <lz4.h>
#include <zstd.h>

#include "import/format/byte_reader.h"

namespace obby::importer {
namespace {

constexpr size_t kChunkHeaderSize = 16;
constexpr size_t kMaxRaw = size_t{256} << 20;
// Any chunk may have kAlwaysAllowed bytes, plus kAllowedPerByte for each byte of the file. Long
// columns of equal values shrink a thousandfold and more, so a plain ratio would reject good files.
constexpr size_t kAlwaysAllowed = size_t{16} << 20;
constexpr size_t kAllowedPerByte = 16;
// The same limits for all chunks together: a few times the memory of the document made from them.
constexpr size_t kTotalAlwaysAllowed = size_t{192} << 20;
constexpr size_t kTotalAllowedPerByte = 256;
constexpr size_t kLz4MaxRatio = 255;
constexpr std::string_view kZstdMagic("\x28\xb5\x2f\xfd", 4);

Status checkRawLength(const Chunk& chunk, size_t fileSize) {
  const size_t raw = chunk.rawLength;
  const bool zstd = chunk.body.substr(0, 4) == kZstdMagic;
  if (raw > kMaxRaw || chunk.body.size() > kMaxRaw ||
      raw > kAlwaysAllowed + kAllowedPerByte * fileSize ||
      (!zstd && raw > kLz4MaxRatio * chunk.body.size() + 64)) {
    return chunkError(chunk, "claims to hold " + std::to_string(raw) +
                                 " bytes; its packed size is " + std::to_string(chunk.body.size()));
  }
  return {};
}

Result<Chunk> readHeader(std::string_view file, size_t offset) {
  ByteReader reader(file.substr(offset));
  const std::string_view name = reader.bytes(4);
  const uint32_t packed = reader.u32(), raw = reader.u32();
  reader.u32();
  Chunk chunk;
  chunk.offset = offset;
  chunk.rawLength = raw;
  chunk.compressed = packed != 0;
  if (!reader.ok()) return chunkError(chunk, "the file ends before its END chunk");
  for (const char c : name.substr(0, name.find('\0'))) {
    if (c < ' ' || c > '~')
      return chunkError(chunk, "expected a chunk name of printable characters");
    chunk.name += c;
  }
  chunk.body = reader.bytes(chunk.compressed ? packed : raw);
  if (!reader.ok()) {
    return chunkError(chunk, "claims to hold " + std::to_string(chunk.compressed ? packed : raw) +
                                 " bytes, but the file ends after " +
                                 std::to_string(file.size() - offset - kChunkHeaderSize));
  }
  return chunk;
}

}  // namespace

Error chunkError(const Chunk& chunk, std::string message) {
  return Error{{},
               "byte " + std::to_string(chunk.offset),
               chunk.name,
               std::move(message),
               "save the file again in Studio"};
}

Result<std::vector<Chunk>> listChunks(std::string_view file, size_t firstOffset) {
  std::vector<Chunk> chunks;
  for (size_t at = firstOffset;;) {
    OBBY_ASSIGN(Chunk chunk, readHeader(file, at));
    at += kChunkHeaderSize + chunk.body.size();
    chunks.push_back(std::move(chunk));
    if (chunks.back().name == "END") return chunks;
  }
}

Result<ChunkData> decompress(const Chunk& chunk, size_t fileSize, size_t& total) {
  if (!chunk.compressed) return ChunkData{chunk.body, nullptr};
  OBBY_RETURN_IF_ERROR(checkRawLength(chunk, fileSize));
  total += chunk.rawLength;
  if (total > kTotalAlwaysAllowed + kTotalAllowedPerByte * fileSize) {
    return chunkError(chunk, "the chunks up to this one claim to hold " + std::to_string(total) +
                                 " bytes; the file size is " + std::to_string(fileSize));
  }
  ChunkData out;
  // The buffer is not cleared: untouched pages cost nothing.
  out.owned.reset(new char[chunk.rawLength > 0 ? chunk.rawLength : 1]);
  size_t got = 0;
  bool good = false;
  const bool zstd = chunk.body.substr(0, 4) == kZstdMagic;
  if (zstd) {
    got = ZSTD_decompress(out.owned.get(), chunk.rawLength, chunk.body.data(), chunk.body.size());
    good = ZSTD_isError(got) == 0;
  } else {
    const int n =
        LZ4_decompress_safe(chunk.body.data(), out.owned.get(), static_cast<int>(chunk.body.size()),
                            static_cast<int>(chunk.rawLength));
    good = n >= 0;
    got = good ? static_cast<size_t>(n) : 0;
  }
  if (!good)
    return chunkError(chunk, zstd ? "the zstd data is damaged" : "the LZ4 data is damaged");
  if (got != chunk.rawLength) {
    return chunkError(chunk, "claims to hold " + std::to_string(chunk.rawLength) +
                                 " bytes, but holds " + std::to_string(got));
  }
  out.bytes = std::string_view(out.owned.get(), got);
  return out;
}

}  // namespace obby::importer
