// Decodes the groups. The blob holds a byte 1 and the number of groups. Then it holds, for each
// group, its id, the size of its mask (4), the mask, the length of its name, and the name.
#include "engine/collision_matrix.h"

namespace obby::engine {
namespace {

constexpr uint8_t kGroupsVersion = 1, kMaskBytes = 4;

// Reads bytes from the front. Past the end it returns zeros and sets `ended`.
struct GroupReader {
  std::string_view left;
  bool ended = false;

  std::string_view bytes(size_t count) {
    ended = ended || count > left.size();
    const std::string_view taken = left.substr(0, ended ? 0 : count);
    left.remove_prefix(taken.size());
    return taken;
  }
  uint32_t number(size_t count) {
    uint32_t value = 0, shift = 0;
    for (const char byte : bytes(count)) {
      value |= uint32_t(uint8_t(byte)) << shift;
      shift += 8;
    }
    return value;
  }
};

}  // namespace

Result<GroupMatrix> decodeGroups(std::string_view blob) {
  GroupMatrix matrix;
  matrix.masks.fill(~0u);
  GroupReader reader{blob};
  const uint32_t version = reader.number(1), count = reader.number(1);
  if (version != kGroupsVersion)
    return makeError("the data of the collision groups has an unknown version");
  for (uint32_t i = 0; i < count && !reader.ended; ++i) {
    const uint32_t id = reader.number(1), bytes = reader.number(1);
    const uint32_t mask = reader.number(kMaskBytes);
    const std::string name(reader.bytes(reader.number(1)));
    if (bytes != kMaskBytes || id >= matrix.masks.size())
      return makeError("a collision group has an invalid id or mask");
    matrix.masks[id] = mask;
    matrix.ids[name] = uint8_t(id);
  }
  if (reader.ended) return makeError("the data of the collision groups ends early");
  return matrix;
}

std::string_view groupBytes(const Instance& instance) {
  const auto* own = property<std::string>(instance, "CollisionGroupData");
  const auto* shared = property<SharedBlob>(instance, "CollisionGroupData");
  return own ? std::string_view(*own) : shared ? std::string_view(*shared->bytes) : "";
}

}  // namespace obby::engine
