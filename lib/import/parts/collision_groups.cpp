#include "import/parts/collision_groups.h"

#include <algorithm>

#include "engine/classes/class_defaults.h"
#include "import/document/classes.h"

namespace obby::importer {
namespace {

constexpr const char* kDefaultGroup = "Default";

bool scriptsSetGroups(const Tree& tree) {
  for (InstanceId id = 0; id < tree.size(); ++id) {
    if (!isScriptClass(tree.at(id).className)) continue;
    const auto* source = property<std::string>(tree.at(id), "Source");
    if (source && source->find("CollisionGroup") != std::string::npos) return true;
  }
  return false;
}

// Returns the part that represents the place's own character model, or kNoInstance if it has none.
InstanceId characterPart(const Tree& tree) {
  const InstanceId player = tree.service("StarterPlayer");
  if (player == kNoInstance) return kNoInstance;
  const InstanceId model = tree.child(player, "StarterCharacter");
  if (model == kNoInstance) return kNoInstance;
  for (const char* name : {"UpperTorso", "Torso", "HumanoidRootPart"})
    if (const InstanceId part = tree.child(model, name); part != kNoInstance) return part;
  return kNoInstance;
}

}  // namespace

std::string groupNameOf(const Instance& part) {
  const auto name = get<std::string>(part, "CollisionGroup");
  if (!name.empty() && name != kDefaultGroup) return name;
  const auto id = get<int64_t>(part, "CollisionGroupId");
  return id == 0 ? kDefaultGroup : "number " + std::to_string(id);
}

CollisionGroups::CollisionGroups(const Tree& tree, const ObservedPlace& place, bool scriptsTell,
                                 LevelDraft& level)
    : tree_(tree), ran_(place.ran) {
  if (scriptsTell) reported_ = place.report.collisionGroups;
  matrix_.masks.fill(~0u);
  for (const char* service : {"Workspace", "PhysicsService"}) {
    const InstanceId id = tree.service(service);
    if (id == kNoInstance || engine::groupBytes(tree.at(id)).empty()) continue;
    auto matrix = engine::decodeGroups(engine::groupBytes(tree.at(id)));
    if (!matrix) {
      level.noteUnmodelled("collision groups", tree, id, matrix.error().text());
      continue;
    }
    matrix_ = *std::move(matrix);
    isSaved_ = true;
  }
  byScripts_ = scriptsSetGroups(tree);
  const InstanceId workspace = tree.service("Workspace");
  touchesUseGroups_ =
      workspace != kNoInstance && get<bool>(tree.at(workspace), "TouchesUseCollisionGroups");
  const InstanceId character = characterPart(tree);
  if (character != kNoInstance) players_ = idOf(tree.at(character));
}

uint8_t CollisionGroups::idOf(const Instance& part) const {
  const auto name = get<std::string>(part, "CollisionGroup");
  const auto named = matrix_.ids.find(name);
  if (named != matrix_.ids.end() && named->second != 0) return named->second;
  const auto id = get<int64_t>(part, "CollisionGroupId");
  const bool isKnown = name.empty() || name == kDefaultGroup;
  return isKnown && id > 0 && size_t(id) < matrix_.masks.size() ? uint8_t(id) : 0;
}

void CollisionGroups::apply(PartDraft& part) const {
  if (ran_) return;
  const uint8_t group = idOf(tree_.at(part.id));
  const bool meets =
      (matrix_.masks[group] >> players_ & 1) != 0 && (matrix_.masks[players_] >> group & 1) != 0;
  if (meets || !part.solid) return;
  part.solid = false;
  if (touchesUseGroups_) part.touch = false;
  part.evidence.push_back(passedEvidence(tree_.at(part.id)));
}

Evidence passedEvidence(const Instance& part) {
  return {"collision", "players pass through collision group " + groupNameOf(part), false};
}

bool CollisionGroups::isSettled(const Instance& part) const {
  const std::string group = groupNameOf(part);
  if (group == kDefaultGroup) return true;
  if (std::find(reported_.begin(), reported_.end(), group) != reported_.end()) return true;
  const auto name = get<std::string>(part, "CollisionGroup");
  const bool isNamed = !name.empty() && name != kDefaultGroup;
  return isSaved_ && !byScripts_ && (!isNamed || matrix_.ids.count(name) > 0);
}

}  // namespace obby::importer
