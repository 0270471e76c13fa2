// Reads the collision groups that a place saves: CollisionGroupData of Workspace or PhysicsService.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/document.h"

namespace obby::engine {

// The names of the groups, and a bit for each group that a group collides with.
struct GroupMatrix {
  std::map<std::string, uint8_t, std::less<>> ids;
  std::array<uint32_t, 32> masks;
};

// Decodes the groups. Fails if the blob is damaged.
Result<GroupMatrix> decodeGroups(std::string_view blob);

// Returns the CollisionGroupData of an instance, or an empty view if it has none.
std::string_view groupBytes(const Instance& instance);

}  // namespace obby::engine
