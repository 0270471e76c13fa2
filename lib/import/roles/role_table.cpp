// Lists the roles and the order of evidence.
#include <algorithm>

#include "import/classes.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

//   role                tags, class           markers              names and defaults
constexpr RoleRow kRoles[] = {
    {"goal", goalFromTags, nullptr, goalFromNames},
    {"checkpoint", checkpointFromTags, checkpointFromMarkers, checkpointFromNames},
    {"kill", killFromTags, killFromMarkers, killFromNames},
    {"jumpPad", jumpPadFromTags, jumpPadFromMarkers, nullptr},
    {"boost", nullptr, boostFromMarkers, nullptr},
    {"oneWay", oneWayFromTags, oneWayFromMarkers, nullptr},
    {"conveyor", conveyorFromTags, conveyorFromMarkers, conveyorFromVelocity},
    {"vanish", vanishFromTags, vanishFromMarkers, nullptr},
    {"seat", seatFromClass, nullptr, nullptr},
    {"ladder", nullptr, nullptr, ladderFromStacks},
    {"motion", movingFromTags, movingFromMarkers, movingFromConstraints},
};

}  // namespace

RoleContext::RoleContext(const Tree& treeIn, const Assemblies& assembliesIn, LevelDraft& levelIn)
    : tree(treeIn), assemblies(assembliesIn), level(levelIn) {
  for (size_t i = 0; i < level.parts.size(); ++i) index_[level.parts[i].id] = i;
}

PartDraft* RoleContext::part(InstanceId id) {
  const auto it = index_.find(id);
  return it == index_.end() ? nullptr : &level.parts[it->second];
}

std::vector<PartDraft*> RoleContext::partsOf(InstanceId id) {
  std::vector<PartDraft*> parts;
  for (InstanceId below : tree.partsOf(id))
    if (PartDraft* draft = part(below)) parts.push_back(draft);
  return parts;
}

bool RoleContext::hasParts(InstanceId id) {
  if (id >= tree.size()) return false;
  if (tree.isPart(id)) return part(id) != nullptr;
  const auto [known, isNew] = holders_.try_emplace(id, false);
  std::vector<InstanceId> open;
  if (isNew) open.push_back(id);
  while (!open.empty() && !known->second) {
    const InstanceId next = open.back();
    open.pop_back();
    known->second = part(next) != nullptr;
    const auto& children = tree.at(next).children;
    open.insert(open.end(), children.begin(), children.end());
  }
  return known->second;
}

void RoleContext::eachTagged(
    const std::vector<std::string_view>& tags,
    const std::function<void(InstanceId, const std::string&)>& visit) const {
  for (InstanceId id = 0; id < tree.size(); ++id) {
    const auto& own = tree.at(id).tags;
    const auto found = std::find_if(own.begin(), own.end(), [&](const std::string& tag) {
      return std::find(tags.begin(), tags.end(), lower(tag)) != tags.end();
    });
    if (found != own.end()) visit(id, *found);
  }
}

void RoleContext::eachMarker(const std::function<void(InstanceId, InstanceId)>& visit) const {
  for (InstanceId id = 0; id < tree.size(); ++id) {
    const Instance& marker = tree.at(id);
    if (marker.parent == kNoInstance) continue;
    if (isValueClass(marker.className) || marker.className == "Configuration")
      visit(id, marker.parent);
  }
}

std::string markerWords(const Tree& tree, InstanceId marker) {
  std::string words = lower(tree.at(marker).name);
  for (const auto& tag : tree.at(marker).tags) words += ' ' + lower(tag);
  return words;
}

bool hasEvidence(const PartDraft& part, const char* role) {
  return std::any_of(part.evidence.begin(), part.evidence.end(),
                     [&](const Evidence& e) { return e.role == role; });
}

bool hasRole(const PartDraft& part) {
  return std::any_of(part.evidence.begin(), part.evidence.end(), [](const Evidence& e) {
    return e.role != "anchored" && e.role != "shape" && e.role != "scripted" &&
           e.role != "collision" && e.role != kHarmless;
  });
}

void findRoles(RoleContext& context) {
  for (const RoleFinder RoleRow::*finder :
       {&RoleRow::fromTags, &RoleRow::fromMarkers, &RoleRow::fromNames})
    for (const RoleRow& role : kRoles)
      if (role.*finder) (role.*finder)(context);
}

}  // namespace obby::importer
