// Union-find over the rigid joints of a document.
#include "import/document/assemblies.h"

#include <algorithm>

#include "engine/classes/class_defaults.h"
#include "import/document/classes.h"

namespace obby::importer {
namespace {

InstanceId refTo(const Tree& tree, InstanceId id, const char* name) {
  const auto* ref = property<Ref>(tree.at(id), name);
  return ref && ref->target < tree.size() ? ref->target : kNoInstance;
}

InstanceId partEnd(const Tree& tree, InstanceId joint, const char* direct, const char* internal,
                   const char* attachment) {
  for (const char* name : {direct, internal}) {
    const InstanceId part = refTo(tree, joint, name);
    if (part != kNoInstance && tree.isPart(part)) return part;
  }
  InstanceId id = refTo(tree, joint, attachment);
  while (id != kNoInstance && !tree.isPart(id)) id = tree.at(id).parent;
  return id;
}

bool isSwitchedOn(const Instance& joint) {
  return propertyOr(joint, "Enabled", true) && propertyOr(joint, "EnabledInternal", true);
}

}  // namespace

JointEnds jointEnds(const Tree& tree, InstanceId joint) {
  return {partEnd(tree, joint, "Part0", "Part0Internal", "Attachment0"),
          partEnd(tree, joint, "Part1", "Part1Internal", "Attachment1")};
}

Assemblies::Assemblies(const Tree& tree) : parent_(tree.size()) {
  for (InstanceId id = 0; id < parent_.size(); ++id) parent_[id] = id;
  for (InstanceId id = 0; id < tree.size(); ++id) {
    if (!isRigidJointClass(tree.at(id).className) || !isSwitchedOn(tree.at(id))) continue;
    const JointEnds ends = jointEnds(tree, id);
    if (ends.first != kNoInstance && ends.second != kNoInstance) join(ends.first, ends.second);
  }
  anchored_.assign(tree.size(), 0);
  for (InstanceId id = 0; id < tree.size(); ++id) {
    if (!tree.isPart(id)) continue;
    const InstanceId root = find(id);
    if (get<bool>(tree.at(id), "Anchored")) anchored_[root] = 1;
    if (root != id) members_[root].push_back(id);
  }
}

InstanceId Assemblies::find(InstanceId id) const {
  while (parent_[id] != id) id = parent_[id] = parent_[parent_[id]];
  return id;
}

void Assemblies::join(InstanceId a, InstanceId b) {
  a = find(a);
  b = find(b);
  if (a != b) parent_[std::max(a, b)] = std::min(a, b);
}

bool Assemblies::anchored(InstanceId part) const { return anchored_[find(part)] != 0; }

std::vector<InstanceId> Assemblies::members(InstanceId part) const {
  const InstanceId root = find(part);
  std::vector<InstanceId> all = {root};
  const auto it = members_.find(root);
  if (it != members_.end()) all.insert(all.end(), it->second.begin(), it->second.end());
  return all;
}

}  // namespace obby::importer
