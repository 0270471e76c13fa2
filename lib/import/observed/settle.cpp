#include "import/observed/settle.h"

#include <algorithm>
#include <string>
#include <utility>

namespace obby::importer {
namespace {

using engine::Change;
using engine::Plain;

struct ToValue {
  const std::string& property;

  Value operator()(std::monostate) const { return {}; }
  Value operator()(double number) const {
    if (property == "Material" || property == "Shape") return EnumItem{uint32_t(number), {}};
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

}  // namespace

std::map<InstanceId, InstanceId> addMadeParts(Document& document, const engine::Report& report) {
  std::map<InstanceId, InstanceId> ids;
  const InstanceId workspace = workspaceOf(document);
  for (const engine::MadePart& made : report.made) {
    const auto id = InstanceId(document.instances.size());
    Instance instance;
    if (made.origin < document.instances.size()) {
      instance = document.instances[made.origin];
      instance.children.clear();
    }
    instance.className = made.className;
    instance.name = made.name;
    instance.parent = workspace;
    document.instances.push_back(std::move(instance));
    (workspace == kNoInstance ? document.roots : document.instances[workspace].children)
        .push_back(id);
    for (const auto& [property, value] : made.properties) set(document, id, property, value);
    ids[made.id] = id;
  }
  return ids;
}

bool keepsMoving(const engine::Report& report, InstanceId part) {
  const auto track = report.undisturbed.tracks.find(part);
  if (track == report.undisturbed.tracks.end()) return false;
  return track->second.poses.back().frame / 60.0 > report.probedAt;
}

void settle(Document& document, const engine::Report& report) {
  std::map<std::pair<InstanceId, std::string>, const Change*> last;
  for (const Change& change : report.undisturbed.changes)
    last[{change.target, change.property}] = &change;
  for (const auto& [key, change] : last) {
    const bool known = key.first < document.instances.size();
    if (!known || change->time > report.probedAt) continue;
    if (key.second != "Parent")
      set(document, key.first, key.second, change->value);
    else if (const bool* stays = std::get_if<bool>(&change->value); stays && !*stays)
      leaveTree(document, key.first);
  }
  for (const auto& [id, track] : report.undisturbed.tracks)
    if (id < document.instances.size() && !keepsMoving(report, id))
      document.instances[id].properties["CFrame"] = track.poses.back().pose;
}

}  // namespace obby::importer
