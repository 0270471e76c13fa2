// SpawnLocations of a scene, and the spawns of its level.
#pragma once

#include <string>
#include <vector>

#include "import/scene.h"

namespace obby::test {

inline InstanceId spawn(Scene& scene, const std::string& name, Vec3 position, InstanceId parent) {
  return scene.part(name, position, parent, "SpawnLocation");
}
inline InstanceId spawn(Scene& scene, const std::string& name, Vec3 position) {
  return spawn(scene, name, position, scene.workspace);
}

// Returns the names of the level's spawns in order.
inline std::vector<std::string> order(const LevelDraft& level) {
  std::vector<std::string> names;
  for (const auto& s : level.spawns) names.push_back(s.name);
  return names;
}
using Names = std::vector<std::string>;

// Returns the names of the spawns after the start.
inline Names checkpoints(const LevelDraft& level) {
  Names names = order(level);
  if (!names.empty()) names.erase(names.begin());
  return names;
}

}  // namespace obby::test
