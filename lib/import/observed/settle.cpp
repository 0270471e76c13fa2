#include "import/observed/settle.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "import/document/classes.h"

namespace obby::importer {
namespace {

using engine::Change;
using engine::Plain;

// Properties whose numbers stand for enum items.
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

// Returns the property's name in documents.
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

// Puts a part from a storage into the world. Its model stays in the storage.
void joinWorld(Document& document, InstanceId id) {
  const InstanceId workspace = workspaceOf(document);
  if (workspace == kNoInstance || workspace > id || isBelow(document, id, workspace)) return;
  leaveTree(document, id);
  document.instances[id].parent = workspace;
  document.instances[workspace].children.push_back(id);
}

bool isBringing(const Change& change) {
  const bool* const there = std::get_if<bool>(&change.value);
  return change.property == "Parent" && there && *there;
}

void addBrought(const engine::Observation& seen, std::set<InstanceId>& brought) {
  std::set<InstanceId> changed;  // a part whose first change removes it was in the world
  for (const Change& change : seen.changes)
    if (change.property == "Parent" && changed.insert(change.target).second && isBringing(change))
      brought.insert(change.target);
}

// Returns the parts that only a touch or a use brings into the world.
std::set<InstanceId> broughtByTouches(const engine::Report& report) {
  std::set<InstanceId> brought;
  for (const engine::Probe& probe : report.probes) addBrought(probe.seen, brought);
  for (const engine::Revisit& revisit : report.revisits) addBrought(revisit.probe.seen, brought);
  for (const Change& change : report.undisturbed.changes)
    if (change.property == "Parent" && change.time > report.probedAt) brought.erase(change.target);
  return brought;
}

// Puts the part into the world or takes it out, as a script did at the start.
void settleParent(Document& document, InstanceId id, bool stays) {
  const bool isPart = isPartClass(document.instances[id].className);
  if (stays && isPart)
    joinWorld(document, id);
  else if (!stays && isPart)
    leaveTree(document, id);
  else if (!stays)
    document.instances[id].properties["Enabled"] = false;  // disables a joint
}

bool samePlace(const Pose& a, const Pose& b) {
  return a.position == b.position && a.rotation.x == b.rotation.x && a.rotation.y == b.rotation.y;
}

// Returns the last frame that changed the pose.
uint32_t lastChange(const engine::Track& track) {
  size_t last = track.poses.size() - 1;
  while (last > 0 && samePlace(track.poses[last - 1].pose, track.poses[last].pose)) --last;
  return track.poses[last].frame;
}

// Returns true if the part moves step by step; otherwise scripts placed it at once.
bool movesInSteps(const engine::Track& track) {
  constexpr uint32_t kLongestGap = 30, kShortest = 15, kFewest = 3;  // frames, frames, steps
  const Pose* last = &track.start;
  uint32_t first = 0, before = 0, steps = 0;
  for (const auto& [frame, pose] : track.poses) {
    if (samePlace(*last, pose)) continue;
    last = &pose;
    if (steps == 0 || frame - before > kLongestGap) first = frame, steps = 0;
    before = frame;
    if (++steps >= kFewest && frame - first >= kShortest) return true;
  }
  return false;
}

}  // namespace

std::map<InstanceId, InstanceId> addMadeParts(Document& document, const engine::Report& report) {
  std::map<InstanceId, InstanceId> ids;
  const InstanceId workspace = workspaceOf(document);
  // Returns the id in the document, or `unknown` for an instance that was not added.
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

bool isMadeLater(const engine::Report& report, InstanceId part) {
  if (report.made.empty() || part < report.made.front().id) return false;
  const size_t index = part - report.made.front().id;  // ids follow the order of the list
  return index < report.made.size() && report.made[index].later;
}

bool movesByItself(const engine::Report& report, InstanceId part) {
  constexpr double kPlacing = 0.1;  // seconds for scripts to place a new part
  const auto found = report.undisturbed.tracks.find(part);
  if (found == report.undisturbed.tracks.end()) return false;
  const engine::Track& track = found->second;
  const double settled = isMadeLater(report, part)
                             ? track.poses.front().frame * engine::kFrame + kPlacing
                             : report.probedAt;
  return lastChange(track) * engine::kFrame > settled || movesInSteps(track);
}

Pose poseAtStart(const engine::Track& track, bool isMade) {
  const engine::Placed& first = track.poses.front();
  return isMade || first.frame == 0 ? first.pose : track.start;
}

namespace {

using Key = std::pair<InstanceId, std::string>;

// Returns one change for each property: the last one before the probes. If the property changes
// again later, the last one within kStart counts. timers.cpp handles parts that scripts show and
// hide.
std::map<Key, const Change*> settledChanges(const engine::Report& report) {
  constexpr double kStart = 0.1;  // seconds
  std::map<Key, const Change*> start, settled;
  for (const Change& change : report.undisturbed.changes) {
    const Key key = {change.target, change.property};
    if (change.time <= kStart) start[key] = &change;
    if (change.time <= report.probedAt) settled[key] = &change;
    if (change.time <= report.probedAt || !settled.contains(key)) continue;
    const auto first = start.find(key);
    const bool goes = change.property == "Parent" || change.property == "CanCollide";
    const bool byFile = first != start.end() && first->second->line.script == kNoInstance;
    if (first == start.end() || (goes && !byFile))
      settled.erase(key);
    else
      settled[key] = first->second;
  }
  return settled;
}

}  // namespace

std::set<InstanceId> settle(Document& document, const engine::Report& report) {
  const auto settled = settledChanges(report);
  std::set<InstanceId> brought = broughtByTouches(report);
  std::erase_if(brought, [&](InstanceId id) { return id >= document.instances.size(); });
  for (const auto& [key, change] : settled) {
    if (key.first >= document.instances.size()) continue;
    const bool* const stays = std::get_if<bool>(&change->value);
    if (key.second != "Parent")
      set(document, key.first, key.second, change->value);
    else if (stays && (*stays || !brought.contains(key.first)))
      settleParent(document, key.first, *stays);
  }
  // Parts that come and go belong to the world.
  std::set<InstanceId> coming = brought;
  for (const Change& change : report.undisturbed.changes)
    if (isBringing(change) && change.target < document.instances.size() &&
        !settled.contains({change.target, change.property}))
      coming.insert(change.target);
  for (const InstanceId id : coming)
    if (isPartClass(document.instances[id].className)) joinWorld(document, id);
  const size_t own = document.instances.size() - report.made.size();
  for (const auto& [id, track] : report.undisturbed.tracks)
    if (id < document.instances.size())
      document.instances[id].properties["CFrame"] =
          movesByItself(report, id) ? poseAtStart(track, id >= own) : track.poses.back().pose;
  return brought;
}

}  // namespace obby::importer
