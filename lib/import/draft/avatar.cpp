#include "import/draft/avatar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/classes/class_defaults.h"

namespace obby::importer {
namespace {

constexpr uint32_t kR6 = 0, kR15 = 1;      // GameSettingsAvatar
constexpr uint32_t kOuterBox = 0;          // GameSettingsR15Collision
constexpr uint32_t kSingleCollider = 1;    // CollisionMode
constexpr uint32_t kUseParts = 0;          // HitAndTouchDetectionMode, TouchAndQueryDetectionMode
constexpr Vec3 kColliderSize = {2, 3, 1};  // the engine's default
constexpr float kMinScale = 0.25f, kMaxScale = 4, kMinCollider = 0.1f, kMaxCollider = 20;

// Returns the scale in the setting's range that is nearest to 1, the rig's own.
float scaleOf(const Instance& starter, const std::string& setting) {
  const NumberRange* range = property<NumberRange>(starter, setting);
  if (range == nullptr || !(range->min <= range->max)) return 1;
  return std::clamp(std::clamp(1.0f, range->min, range->max), kMinScale, kMaxScale);
}

// Returns true for proportions that no scaled classic body has.
bool isTaller(const Instance& starter) {
  const NumberRange* type = property<NumberRange>(starter, "GameSettingsScaleRangeBodyType");
  return type != nullptr && type->min > 0;
}

void noteR15(const Tree& tree, InstanceId player, LevelDraft& level) {
  const Instance& starter = tree.at(player);
  std::string note = "simulated as the classic R15 body";
  if (level.avatar.height != 1) note += fmt::format(", {:.3g} times as high", level.avatar.height);
  if (level.avatar.width != 1) note += fmt::format(", {:.3g} times as wide", level.avatar.width);
  if (get<EnumItem>(starter, "GameSettingsR15Collision").value == kOuterBox) {
    note += "; in the game, the collision boxes of other avatars follow their meshes";
  }
  if (isTaller(starter)) note += "; the place's body type has other proportions than this body";
  level.noteIgnored("R15 avatars", tree.path(player), note);
}

InstanceId collisionRules(const Tree& tree) {
  for (InstanceId id = 0; id < tree.size(); ++id) {
    if (tree.at(id).className == "AvatarCollisionRules") return id;
  }
  return kNoInstance;
}

void readCollider(const Tree& tree, LevelDraft& level) {
  const InstanceId rules = collisionRules(tree);
  if (rules == kNoInstance) return;
  const Instance& from = tree.at(rules);
  if (get<EnumItem>(from, "CollisionMode").value != kSingleCollider) return;
  const Vec3* const stated = property<Vec3>(from, "SingleColliderSize");
  const Vec3 size = stated != nullptr ? *stated : kColliderSize;
  const auto within = [](float v) { return v >= kMinCollider && v <= kMaxCollider; };
  if (!within(size.x) || !within(size.y) || !within(size.z)) return;
  level.avatar.collider = size;
  // The engine has had two names for the setting.
  level.avatar.colliderTouches =
      get<EnumItem>(from, "HitAndTouchDetectionMode").value != kUseParts ||
      get<EnumItem>(from, "TouchAndQueryDetectionMode").value != kUseParts;
  std::string note = fmt::format("the body collides as one box of {:.3g} x {:.3g} x {:.3g} studs",
                                 size.x, size.y, size.z);
  note += "; simulated only above the hips, and only at the head while Jumping";
  level.noteIgnored("single collider", tree.path(rules), note);
}

}  // namespace

void readAvatar(const Tree& tree, LevelDraft& level) {
  const InstanceId player = tree.service("StarterPlayer");
  if (player == kNoInstance) return;
  readCollider(tree, level);
  const Instance& starter = tree.at(player);
  const EnumItem* const avatar = property<EnumItem>(starter, "GameSettingsAvatar");
  if (avatar == nullptr) return;
  Avatar& to = level.avatar;
  if (avatar->value == kR6) {
    to.bodies = {"r6"};
    to.body = "r6";
  } else if (avatar->value == kR15) {
    to.bodies = {"r15"};
    to.body = "r15";
    to.height = scaleOf(starter, "GameSettingsScaleRangeHeight");
    to.width = scaleOf(starter, "GameSettingsScaleRangeWidth");
    noteR15(tree, player, level);
  } else {
    to.bodies = {"r6", "r15"};
    level.noteIgnored("avatar chosen by the player", tree.path(player),
                      "simulated as the R6 body; obby-solve --body each also answers for R15");
  }
}

}  // namespace obby::importer
