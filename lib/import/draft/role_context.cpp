#include "import/draft/role_context.h"

#include <algorithm>

#include "import/document/classes.h"

namespace obby::importer {

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

}  // namespace obby::importer
