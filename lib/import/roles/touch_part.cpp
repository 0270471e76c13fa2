// Finds the part of a tagged model that a player has to touch.
#include "import/document/pivot.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

// Names in lower case, best first.
constexpr std::string_view kTouchNames[] = {"touch", "goal",       "hitbox", "trigger",
                                            "pad",   "checkpoint", "part",   "spawn"};

}  // namespace

PartDraft* touchPart(RoleContext& context, InstanceId id) {
  const auto parts = context.partsOf(id);
  for (std::string_view name : kTouchNames)
    for (PartDraft* part : parts)
      if (lower(context.tree.at(part->id).name) == name) return part;
  if (PartDraft* part = context.part(primaryPartOf(context.tree, id))) return part;
  return parts.empty() ? nullptr : parts.front();
}

}  // namespace obby::importer
