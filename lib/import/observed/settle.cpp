#include "import/observed/settle.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "import/classes.h"

namespace obby::importer {
namespace {

using engine::Change;
using engine::Plain;

// Properties whose numbers are items of enums.
constexpr const char* kEnums[] = {
    "Material",   "Shape",          "ActuatorType",    "AngularActuatorType",   "Mode",
    "RelativeTo", "ForceLimitMode", "ForceRelativeTo", "VelocityConstraintMode"};

struct ToValue {
  const std::string& property;

  Value operator()(std::monostate) const { return {}; }
  Value operator()(double number) const {
    for (const char* const name : kEnums)
      if (property == name) return EnumItem{uint32_t(number), {}};
    return number;
  }
  template <class T>
  Value operator()(const T& value) const {
    return value;
  }
};

// In the names that documents use.
std::string documentName(const std::string& property) {
  if (property == "AssemblyLinearVelocity") return "Velocity";
  if (property == "AssemblyAngularVelocity") return "RotVelocity";
  return property;
}

void set(Document& document, InstanceId id, const std::string& property, const Plain& value) {
  const std::string name = documentName(property);
  Value converted = std::visit(ToValue{name}, value);
  if (!std::holds_alternative<std::monostate>(converted))
    document.instances[id].properties[name] = std::move(converted);
}

InstanceId workspaceOf(const Document& document) {
  for (const InstanceId root : document.roots)
    if (document.instances[root].className == "Workspace") return root;
  return kNoInstance;
}

void leaveTree(Document& document, InstanceId id) {
  const InstanceId parent = document.instances[id].parent;
  auto& siblings = parent == kNoInstance ? document.roots : document.instances[parent].children;
  std::erase(siblings, id);
  document.instances[id].parent = kNoInstance;
}

bool isBelow(const Document& document, InstanceId id, InstanceId ancestor) {
  while (id != kNoInstance && id != ancestor) id = document.instances[id].parent;
  return id == ancestor;
}

// Of a part from a storage: its model stays there.
void joinWorld(Document& document, InstanceId id) {
  const InstanceId workspace = workspaceOf(document);
  if (workspace == kNoInstance || workspace > id || isBelow(document, id, workspace)) return;
  leaveTree(document, id);
  document.instances[id].parent = workspace;
  document.instances[workspace].children.push_back(id);
}

// Whether a touch or a use puts the part back into the world.
bool comesBack(const engine::Report& report, InstanceId part) {
  const auto brings = [&](const Change& change) {
    const bool* const there = std::get_if<bool>(&change.value);
    return change.target == part && change.property == "Parent" && there && *there;
  };
  return std::any_of(report.probes.begin(), report.probes.end(), [&](const engine::Probe& probe) {
    return std::any_of(probe.seen.changes.begin(), probe.seen.changes.end(), brings);
  });
}

// At the start a script has put the part into the world or taken it out.
void settleParent(Document& document, const engine::Report& report, InstanceId id, bool stays) {
  const bool isPart = isPartClass(document.instances[id].className);
  if (stays && isPart)
    joinWorld(document, id);
  else if (!stays && !comesBack(report, id) && isPart)
    leaveTree(document, id);
  else if (!stays && !comesBack(report, id))
    document.instances[id].properties["Enabled"] = false;  // a joint
}

}  // namespace

std::map<InstanceId, InstanceId> addMadeParts(Document& document, const engine::Report& report) {
  std::map<InstanceId, InstanceId> ids;
  const InstanceId workspace = workspaceOf(document);
  // The id in the document; `unknown` for what was not added.
  const auto known = [&](InstanceId id, InstanceId unknown) {
    const auto added = ids.find(id);
    return added != ids.end() ? added->second : id < engine::kMade ? id : unknown;
  };
  for (const engine::MadePart& made : report.made) {
    const auto id = InstanceId(document.instances.size());
    Instance instance;
    if (made.origin < document.instances.size()) {
      instance = document.instances[made.origin];
      instance.children.clear();
    }
    instance.className = made.className;
    instance.name = made.name;
    instance.parent = isPartClass(made.className) ? workspace : known(made.parent, workspace);
    auto& siblings = instance.parent == kNoInstance ? document.roots
                                                    : document.instances[instance.parent].children;
    siblings.push_back(id);
    document.instances.push_back(std::move(instance));
    for (const auto& [property, value] : made.properties) set(document, id, property, value);
    ids[made.id] = id;
  }
  for (const engine::MadePart& made : report.made)
    for (const auto& [property, target] : made.references)
      document.instances[ids[made.id]].properties[property] = Ref{known(target, kNoInstance)};
  return ids;
}

bool keepsMoving(const engine::Report& report, InstanceId part) {
  const auto track = report.undisturbed.tracks.find(part);
  if (track == report.undisturbed.tracks.end()) return false;
  return track->second.poses.back().frame / 60.0 > report.probedAt;
}

void settle(Document& document, const engine::Report& report) {
  std::map<std::pair<InstanceId, std::string>, const Change*> last;
  std::set<std::pair<InstanceId, std::string>> later;
  for (const Change& change : report.undisturbed.changes)
    if (change.time <= report.probedAt)
      last[{change.target, change.property}] = &change;
    else
      later.emplace(change.target, change.property);
  for (const auto& [key, change] : last) {
    // Those that come and go are looked at elsewhere (timers.cpp).
    const bool goes = key.second == "Parent" || key.second == "CanCollide";
    if (key.first >= document.instances.size() || (goes && later.contains(key))) continue;
    if (key.second != "Parent")
      set(document, key.first, key.second, change->value);
    else if (const bool* const stays = std::get_if<bool>(&change->value))
      settleParent(document, report, key.first, *stays);
  }
  for (const auto& [id, track] : report.undisturbed.tracks) {
    if (id >= document.instances.size()) continue;
    const bool moves = keepsMoving(report, id);
    if (!moves || track.poses.front().frame == 0)
      document.instances[id].properties["CFrame"] =
          moves ? track.poses.front().pose : track.poses.back().pose;
  }
}

}  // namespace obby::importer
