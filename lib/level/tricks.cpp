#include "level/tricks.h"

#include <capnp/schema.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "level/record_values.h"

namespace obby::level {

Result<uint16_t> tricksOf(capnp::List<schema::Trick>::Reader list, const std::string& path) {
  uint16_t bits = 0;
  for (uint32_t i = 0; i < list.size(); ++i) {
    const uint32_t bit = uint32_t(list[i]) < 16 ? 1u << uint32_t(list[i]) : 0;
    if ((bit & kAllTricks) == 0) {
      return pathError(fmt::format("{}[{}]", path, i),
                       "this version of obby does not have this trick");
    }
    bits |= uint16_t(bit);
  }
  return bits;
}

namespace {

// Returns the words of a name such as heldJump, joined by `between`.
std::string wordsOf(std::string_view name, char between) {
  std::string words;
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    if (upper) words += between;
    words += upper ? char(c - 'A' + 'a') : c;
  }
  return words;
}

}  // namespace

std::vector<std::string> trickOptions() {
  std::vector<std::string> names{"none"};
  for (const auto trick : capnp::Schema::from<schema::Trick>().getEnumerants()) {
    names.push_back(wordsOf(trick.getProto().getName().cStr(), '-'));
  }
  names.push_back("all");
  return names;
}

std::string trickName(schema::Trick trick) {
  const auto known = capnp::Schema::from<schema::Trick>().getEnumerants();
  return wordsOf(known[uint32_t(trick)].getProto().getName().cStr(), ' ');
}

Result<uint16_t> tricksNamed(const std::vector<std::string>& options) {
  const std::vector<std::string> known = trickOptions();
  uint16_t bits = 0;
  for (const std::string& name : options) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      return makeError(fmt::format("unknown trick '{}'", name),
                       fmt::format("give {}", fmt::join(known, ", ")));
    }
    const size_t place = size_t(found - known.begin());
    if (place + 1 == known.size()) bits = kAllTricks;
    if (place > 0 && place + 1 < known.size()) bits |= uint16_t(1u << (place - 1));
  }
  return bits;
}

std::vector<schema::Trick> tricksIn(uint16_t bits) {
  std::vector<schema::Trick> tricks;
  for (uint16_t i = 0; i < 16; ++i) {
    if (bits >> i & 1) tricks.push_back(schema::Trick(i));
  }
  return tricks;
}

}  // namespace obby::level
