// Undoes the interleaving, then the transformation of each kind of number.
#include "import/format/columns.h"

namespace obby::importer {
namespace {

template <class Unsigned>
std::vector<Unsigned> deinterleave(ByteReader& reader, size_t count) {
  if (!reader.has(count, sizeof(Unsigned))) return {};
  const std::string_view raw = reader.bytes(count * sizeof(Unsigned));
  std::vector<Unsigned> out(count);
  for (size_t byte = 0; byte < sizeof(Unsigned); ++byte) {
    const char* plane = raw.data() + byte * count;
    for (size_t i = 0; i < count; ++i) {
      out[i] = static_cast<Unsigned>((out[i] << 8) | static_cast<uint8_t>(plane[i]));
    }
  }
  return out;
}

template <class Unsigned, class To, class Transform>
std::vector<To> column(ByteReader& reader, size_t count, Transform transform) {
  const std::vector<Unsigned> raw = deinterleave<Unsigned>(reader, count);
  std::vector<To> out;
  out.reserve(raw.size());
  for (const Unsigned value : raw) out.push_back(transform(value));
  return out;
}

template <class Unsigned>
Unsigned unzigzag(Unsigned value) {
  return static_cast<Unsigned>((value >> 1) ^ (Unsigned{0} - (value & 1)));
}

}  // namespace

std::vector<uint32_t> readUint32Column(ByteReader& reader, size_t count) {
  return deinterleave<uint32_t>(reader, count);
}

std::vector<int32_t> readInt32Column(ByteReader& reader, size_t count) {
  return column<uint32_t, int32_t>(reader, count,
                                   [](uint32_t v) { return static_cast<int32_t>(unzigzag(v)); });
}

std::vector<int64_t> readInt64Column(ByteReader& reader, size_t count) {
  return column<uint64_t, int64_t>(reader, count,
                                   [](uint64_t v) { return static_cast<int64_t>(unzigzag(v)); });
}

std::vector<float> readFloatColumn(ByteReader& reader, size_t count) {
  return column<uint32_t, float>(
      reader, count, [](uint32_t v) { return std::bit_cast<float>((v >> 1) | (v << 31)); });
}

std::vector<int32_t> readReferentColumn(ByteReader& reader, size_t count) {
  uint32_t sum = 0;  // unsigned, so that it wraps instead of overflowing on broken files
  return column<uint32_t, int32_t>(reader, count, [&sum](uint32_t v) {
    sum += unzigzag(v);
    return static_cast<int32_t>(sum);
  });
}

}  // namespace obby::importer
