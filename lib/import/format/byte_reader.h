// Reads little-endian values from a piece of memory and never beyond it. The first read that does
// not fit makes the reader fail permanently. Later reads return zeros, so callers check once at the
// end.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace obby::importer {

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  bool ok() const { return !failed_; }
  size_t position() const { return at_; }
  size_t remaining() const { return failed_ ? 0 : bytes_.size() - at_; }

  // Makes the reader fail: the input makes no sense.
  void fail() { failed_ = true; }

  // Returns true if `count` values of `each` bytes remain; otherwise the reader fails.
  bool has(uint64_t count, uint64_t each = 1) {
    const bool fits = each == 0 || count <= remaining() / each;
    if (!fits) failed_ = true;
    return fits && !failed_;
  }

  std::string_view bytes(size_t count) {
    if (!has(count)) return {};
    const std::string_view out = bytes_.substr(at_, count);
    at_ += count;
    return out;
  }

  uint8_t u8() { return number<uint8_t>(); }
  uint16_t u16() { return number<uint16_t>(); }
  uint32_t u32() { return number<uint32_t>(); }
  int32_t i32() { return static_cast<int32_t>(number<uint32_t>()); }
  uint64_t u64() { return number<uint64_t>(); }
  float f32() { return std::bit_cast<float>(number<uint32_t>()); }
  double f64() { return std::bit_cast<double>(number<uint64_t>()); }

  // Reads a u32 length, then that many bytes.
  std::string_view string() { return bytes(u32()); }

 private:
  template <class Unsigned>
  Unsigned number() {
    const std::string_view raw = bytes(sizeof(Unsigned));
    Unsigned value = 0;
    for (size_t i = 0; i < raw.size(); ++i) {
      value = static_cast<Unsigned>(
          value | (static_cast<Unsigned>(static_cast<uint8_t>(raw[i])) << (8 * i)));
    }
    return value;
  }

  std::string_view bytes_;
  size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace obby::importer
