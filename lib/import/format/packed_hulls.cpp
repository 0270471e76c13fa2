// Decodes packed hulls: nine u32 (see PackedHead), the bounding box (6 floats), the block of plain
// hulls, the symbols of the Edgebreaker hulls, and their corners, hull by hull.
//
// A hull has E symbols. Triangle 0 has three corners; each symbol adds a triangle, and C adds a
// corner with it. S opens a branch and E ends one. The hull ends with its last branch.
#include "import/format/packed_hulls.h"

#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "import/format/byte_reader.h"

namespace obby::importer {
namespace {

constexpr size_t kMaxUnpacked = size_t{16} << 20;
// Any frame may unpack to kAlwaysUnpacked bytes, plus kUnpackedPerByte for each compressed byte:
// corners compress little.
constexpr size_t kAlwaysUnpacked = size_t{16} << 10;
constexpr size_t kUnpackedPerByte = 100;
constexpr int kMaxWindowLog = 24;  // limits the decoder's memory to 16 MB
constexpr size_t kUnpackStep = size_t{64} << 10;
constexpr size_t kCornerBytes = 3 * 4;

Error broken(std::string message) { return Error{{}, {}, "hulls", std::move(message), {}}; }

struct PackedHead {
  uint32_t hulls, corners, faces;    // totals of the Edgebreaker hulls
  uint32_t maxCorners, maxFaces;     // max of any one of these hulls
  uint32_t plainBytes;               // size of the block of plain hulls
  uint32_t symbolBits, symbolBytes;  // sizes of the Edgebreaker symbols
  uint32_t cornerBytes;
};

PackedHead readPackedHead(ByteReader& reader) {
  PackedHead head{};
  for (uint32_t* field : {&head.hulls, &head.corners, &head.faces, &head.maxCorners, &head.maxFaces,
                          &head.plainBytes, &head.symbolBits, &head.symbolBytes, &head.cornerBytes})
    *field = reader.u32();
  reader.bytes(6 * 4);  // the bounding box
  return head;
}

// Reads bits from 32-bit words, the highest first, up to three bits at a time. The bits of the last
// word are its low ones.
class Bits {
 public:
  Bits(std::string_view bytes, uint32_t count) : count_(count) {
    ByteReader reader(bytes);
    for (size_t i = 0; i < (size_t(count) + 31) / 32; ++i) words_.push_back(reader.u32());
    if (count % 32 != 0 && !words_.empty()) words_.back() <<= 32 - count % 32;
  }
  size_t left() const { return count_ - at_; }
  // Returns false past the end, too.
  bool next() {
    if (at_ >= count_) return false;
    const bool bit = ((words_[at_ / 32] >> (31 - at_ % 32)) & 1) != 0;
    ++at_;
    return bit;
  }

 private:
  std::vector<uint32_t> words_;
  size_t at_ = 0, count_;
};

struct Counts {
  size_t corners = 3, faces = 1;
};

// Counts the next hull. Returns false if the symbols end before it.
bool countHull(Bits& bits, Counts& counts) {
  for (size_t branches = 1; branches > 0; ++counts.faces) {
    if (bits.left() == 0) return false;
    if (!bits.next()) {  // C
      ++counts.corners;
      continue;
    }
    if (bits.left() < 2) return false;
    const bool second = bits.next(), third = bits.next();
    if (!second && !third) ++branches;  // S
    if (second && third) --branches;    // E
  }
  return true;
}

Result<std::vector<Vec3>> readCorners(ByteReader& reader, size_t count) {
  if (!reader.has(count, kCornerBytes)) return broken("the data ends before the corners");
  std::vector<Vec3> corners(count);
  for (Vec3& corner : corners) {
    const float x = reader.f32(), y = reader.f32(), z = reader.f32();
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      return broken("a corner is not finite");
    corner = {x, y, z};
  }
  return corners;
}

// Reads the starts of the slices of a list, and the end of the last one: u32 count, u32 each.
Result<std::vector<uint32_t>> readStarts(ByteReader& reader) {
  const uint32_t count = reader.u32();
  if (!reader.has(count, 4)) return broken("the data ends within the plain hulls");
  std::vector<uint32_t> starts(count);
  for (uint32_t& start : starts) start = reader.u32();
  if (!std::is_sorted(starts.begin(), starts.end()) || (count > 0 && starts[0] != 0))
    return broken("the slices of plain hulls are not in order");
  return starts;
}

Status readPlain(std::string_view block, std::vector<std::vector<Vec3>>& hulls) {
  ByteReader reader(block);
  OBBY_ASSIGN(const std::vector<uint32_t> faces, readStarts(reader));
  if (const uint32_t indices = faces.empty() ? 0 : faces.back(); reader.has(indices, 4))
    reader.bytes(size_t(indices) * 4);
  OBBY_ASSIGN(const std::vector<uint32_t> floats, readStarts(reader));
  if (!reader.ok()) return broken("the data ends within the plain hulls");
  if (floats.size() != faces.size()) return broken("plain hulls lack corners or triangles");
  for (size_t i = 1; i < floats.size(); ++i) {
    const uint32_t count = floats[i] - floats[i - 1];
    if (count % 3 != 0) return broken("a plain hull ends within a corner");
    OBBY_ASSIGN(std::vector<Vec3> corners, readCorners(reader, count / 3));
    hulls.push_back(std::move(corners));
  }
  return {};
}

Status readCoded(const PackedHead& head, std::string_view symbols, ByteReader& reader,
                 std::vector<std::vector<Vec3>>& hulls) {
  Bits bits(symbols, head.symbolBits);
  size_t corners = 0, faces = 0;
  for (uint32_t i = 0; i < head.hulls; ++i) {
    Counts counts;
    if (!countHull(bits, counts)) return broken("the symbols end early");
    corners += counts.corners;
    faces += counts.faces;
    OBBY_ASSIGN(std::vector<Vec3> hull, readCorners(reader, counts.corners));
    hulls.push_back(std::move(hull));
  }
  if (corners != head.corners || faces != head.faces || bits.left() > 0)
    return broken("the symbols do not match the counts");
  return {};
}

}  // namespace

Result<std::string> unpackHulls(std::string_view frame) {
  const size_t max = std::min(kMaxUnpacked, kAlwaysUnpacked + kUnpackedPerByte * frame.size());
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                     &ZSTD_freeDCtx);
  ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, kMaxWindowLog);
  std::string out;
  ZSTD_inBuffer input = {frame.data(), frame.size(), 0};
  for (;;) {
    const size_t had = out.size();
    if (had > max) return broken("the zstd frame claims to hold more than its size allows");
    out.resize(had + kUnpackStep);
    ZSTD_outBuffer output = {out.data(), out.size(), had};
    const size_t left = ZSTD_decompressStream(context.get(), &output, &input);
    if (ZSTD_isError(left)) return broken("the zstd data is damaged");
    const bool stuck = output.pos == had && input.pos == input.size;
    out.resize(output.pos);
    if (left == 0) return out;
    if (stuck) return broken("the zstd data ends early");
  }
}

Result<std::vector<std::vector<Vec3>>> decodePackedHulls(std::string_view unpacked) {
  ByteReader reader(unpacked);
  const PackedHead head = readPackedHead(reader);
  const std::string_view plain = reader.bytes(head.plainBytes);
  const std::string_view symbols = reader.bytes(head.symbolBytes);
  if (!reader.ok()) return broken("the data ends early");
  if (symbols.size() < (size_t(head.symbolBits) + 31) / 32 * 4)
    return broken("the symbol data is shorter than its bit count requires");
  if (head.cornerBytes != size_t(head.corners) * kCornerBytes)
    return broken("the number of corners does not match the number of bytes");
  std::vector<std::vector<Vec3>> hulls;
  if (!plain.empty()) OBBY_RETURN_IF_ERROR(readPlain(plain, hulls));
  OBBY_RETURN_IF_ERROR(readCoded(head, symbols, reader, hulls));
  return hulls;
}

}  // namespace obby::importer
