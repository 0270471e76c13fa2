// Decodes Cap'n Proto's packing step by step, so that input may arrive in any pieces. Private to
// lib/io.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace obby::io {

// Each unit of packed bytes (a tag and its data) becomes one or more words.
class Unpacker {
 public:
  enum class State { more, done, overrun };

  // Takes whole units from `in` until `out` has `want` words. `used` counts the bytes taken.
  // Returns `more` if `in` ends inside a unit or after the last one, and `overrun` if a run of
  // words exceeds `want`.
  static State step(std::string_view in, size_t want, std::vector<uint64_t>& out, size_t& used) {
    used = 0;
    while (out.size() < want) {
      const std::string_view rest = in.substr(used);
      const size_t size = unitSize(rest);
      if (size == 0) return State::more;
      const size_t words = unitWords(rest);
      if (words > want - out.size()) return State::overrun;
      const size_t at = out.size();
      out.resize(at + words);
      expand(rest, words, reinterpret_cast<char*>(&out[at]));
      used += size;
    }
    return State::done;
  }

 private:
  // Returns the bytes of the first unit, or 0 if it is incomplete.
  static size_t unitSize(std::string_view in) {
    if (in.empty()) return 0;
    const uint8_t tag = uint8_t(in[0]);
    size_t size = 1 + size_t(__builtin_popcount(tag));
    if (tag == 0 || tag == 0xff) {
      if (in.size() <= size) return 0;
      size += 1 + (tag == 0xff ? size_t(8) * uint8_t(in[size]) : 0);
    }
    return in.size() >= size ? size : 0;
  }

  static size_t unitWords(std::string_view in) {
    const uint8_t tag = uint8_t(in[0]);
    if (tag == 0) return 1 + size_t(uint8_t(in[1]));
    if (tag == 0xff) return 1 + size_t(uint8_t(in[9]));
    return 1;
  }

  static void expand(std::string_view in, size_t words, char* out) {
    const uint8_t tag = uint8_t(in[0]);
    std::memset(out, 0, words * 8);
    size_t from = 1;
    for (int i = 0; i < 8; i++)
      if (tag & (1 << i)) out[i] = in[from++];
    if (tag == 0xff && words > 1) std::memcpy(out + 8, in.data() + 10, (words - 1) * 8);
  }
};

}  // namespace obby::io
