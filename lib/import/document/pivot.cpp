// Reads pivots of parts and models.
#include "import/document/pivot.h"

#include "engine/classes/class_defaults.h"

namespace obby::importer {

Pose pivotOf(const Tree& tree, InstanceId id) {
  if (id == kNoInstance) return {};
  if (tree.isPart(id)) return get<CFrame>(tree.at(id), "CFrame");
  const InstanceId primary = primaryPartOf(tree, id);
  if (primary != kNoInstance) return get<CFrame>(tree.at(primary), "CFrame");
  for (const char* name : {"WorldPivotData", "WorldPivot"})
    if (const auto* stored = property<CFrame>(tree.at(id), name)) return *stored;
  const auto parts = tree.partsOf(id);
  if (parts.empty()) return {};
  Box box{};
  for (size_t i = 0; i < parts.size(); ++i) {
    const Instance& part = tree.at(parts[i]);
    const Box own = boundsOf(get<CFrame>(part, "CFrame"), get<Vec3>(part, "Size") * 0.5f);
    box = i == 0 ? own : join(box, own);
  }
  return {(box.lo + box.hi) * 0.5f, {}};
}

InstanceId primaryPartOf(const Tree& tree, InstanceId id) {
  if (tree.isPart(id)) return kNoInstance;
  const InstanceId primary = get<Ref>(tree.at(id), "PrimaryPart").target;
  const bool below = primary < tree.size() && tree.isPart(primary) && tree.isUnder(primary, id);
  return below ? primary : kNoInstance;
}

}  // namespace obby::importer
