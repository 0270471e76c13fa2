#include "import/level/dynamic.h"

#include <fmt/format.h>

#include "level/level_view.h"

namespace obby::importer {
namespace {

bool isDynamic(const PartDraft& part) { return !part.anchored && part.solid && !part.motion; }

// Returns true for a kit's pushbox. The kit clones the part and unanchors the clone when its button
// is touched.
bool isPushbox(const Tree& tree, const PartDraft& part) {
  return tree.at(part.id).name == "Pushbox" || tree.child(part.id, "IsBox") != kNoInstance;
}

void anchor(const Tree& tree, LevelDraft& level, PartDraft& part, const std::string& why) {
  part.anchored = true;
  part.evidence.push_back({"anchored", why, true});
  level.noteUnmodelled("unanchored part", tree, part.id, "treated as anchored: " + why);
}

// Unanchors the parts that can move on their own. Returns their number.
int unanchorMovable(const Tree& tree, const Assemblies& assemblies, LevelDraft& level) {
  int count = 0;
  for (PartDraft& part : level.parts) {
    if (isPushbox(tree, part) && part.anchored && part.solid && !part.motion) {
      part.anchored = false;
      part.evidence.push_back({"dynamic", "pushbox of a kit", true});
    }
    if (!isDynamic(part)) continue;
    if (assemblies.members(part.id).size() > 1) {
      anchor(tree, level, part, "joined to other unanchored parts");
    } else if (part.vanish) {
      anchor(tree, level, part, "unanchored parts cannot vanish");
    } else {
      ++count;
    }
  }
  return count;
}

}  // namespace

void dynamicParts(const Tree& tree, const Assemblies& assemblies, LevelDraft& level) {
  if (unanchorMovable(tree, assemblies, level) <= level::kMaxBodies) return;
  int left = level::kMaxBodies;
  for (PartDraft& part : level.parts) {
    if (!isDynamic(part) || (isPushbox(tree, part) && left-- > 0)) continue;
    anchor(tree, level, part,
           fmt::format("the level has more than {} unanchored parts", level::kMaxBodies));
  }
}

}  // namespace obby::importer
