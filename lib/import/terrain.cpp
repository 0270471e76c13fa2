// Terrain is lost where the file has voxels of it.
#include "import/terrain.h"

#include <string>

namespace obby::importer {
namespace {

constexpr size_t kEmptyTerrain = 64;  // bytes: voxel data of this size holds nothing to stand on

// Of voxels, which files store as a text of their own or as a shared one.
size_t bytesOf(const Instance& terrain, const char* name) {
  const auto* own = property<std::string>(terrain, name);
  const auto* shared = property<SharedBlob>(terrain, name);
  return own ? own->size() : shared ? shared->bytes->size() : 0;
}

}  // namespace

void noteTerrain(RoleContext& context) {
  const InstanceId workspace = context.tree.service("Workspace");
  if (workspace == kNoInstance) return;
  const InstanceId terrain = context.tree.childOfClass(workspace, "Terrain");
  if (terrain == kNoInstance) return;
  for (const char* name : {"SmoothGrid", "ClusterGridV3", "ClusterGridV2", "ClusterGrid"}) {
    const size_t voxels = bytesOf(context.tree.at(terrain), name);
    if (voxels <= kEmptyTerrain) continue;
    context.level.noteUnmodelled(
        "terrain", context.tree.path(terrain),
        std::to_string(voxels) + " bytes of voxels that players could stand on are left out");
    return;
  }
}

}  // namespace obby::importer
