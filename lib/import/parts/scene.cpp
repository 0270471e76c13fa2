// Walks the world and leaves out characters, gear and screen-only instances. Counts parts in
// storage.
#include "import/parts/scene.h"

#include "engine/classes/class_defaults.h"
#include "import/document/classes.h"

namespace obby::importer {
namespace {

bool isRig(const Tree& tree, InstanceId id) {
  if (!isA(tree.at(id).className, "Model") || tree.at(id).className == "Workspace") return false;
  return tree.childOfClass(id, "Humanoid") != kNoInstance;
}

// Returns why everything below this instance is left out, or null if it stays.
const char* outsideReason(const Tree& tree, InstanceId id) {
  const std::string& className = tree.at(id).className;
  if (isGearClass(className)) return "tool or accessory";
  if (className == "ViewportFrame") return "ViewportFrame";
  if (isRig(tree, id)) return "character with a Humanoid";
  return nullptr;
}

bool isService(const Tree& tree, InstanceId root) {
  const std::string& className = tree.at(root).className;
  return isA(className, "ServiceProvider") || className == "Lighting" ||
         className.find("Storage") != std::string::npos ||
         className.find("Service") != std::string::npos || className.rfind("Starter", 0) == 0 ||
         className.rfind("Replicated", 0) == 0;
}

void countStorage(const Tree& tree, LevelDraft& level) {
  for (InstanceId root : tree.document().roots) {
    if (!isService(tree, root)) continue;
    tree.eachBelow(root, [&](InstanceId id) {
      if (tree.isPart(id))
        level.noteIgnored("part in " + tree.at(root).className, tree.path(id),
                          "stored, not in the world");
      return true;
    });
  }
}

}  // namespace

std::vector<InstanceId> sceneParts(const Tree& tree, LevelDraft& level) {
  std::vector<InstanceId> parts;
  const bool wholePlace = tree.service("Workspace") != kNoInstance;
  const auto visit = [&](InstanceId id) {
    if (const char* reason = outsideReason(tree, id)) {
      for (InstanceId part : tree.partsOf(id))
        level.noteIgnored(std::string("part of a ") + reason, tree.path(part),
                          "not level geometry");
      return false;
    }
    if (!tree.isPart(id)) return true;
    if (tree.at(id).className == "NegateOperation")
      level.noteIgnored("NegateOperation", tree.path(id), "only cuts other parts in Studio");
    else
      parts.push_back(id);
    return true;
  };
  for (InstanceId root : tree.worldRoots())
    if (wholePlace || !isService(tree, root)) tree.eachBelow(root, visit);
  countStorage(tree, level);
  return parts;
}

}  // namespace obby::importer
