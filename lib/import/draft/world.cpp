// Reads the world constants. A StarterHumanoid in StarterPlayer replaces the Character* properties.
#include "import/draft/world.h"

#include <algorithm>
#include <cmath>

#include "engine/classes/class_defaults.h"
#include "import/draft/avatar.h"

namespace obby::importer {
namespace {

constexpr uint32_t kControllerLegacy = 1, kControllerDefault = 0;
constexpr uint32_t kServerAuthority = 0;
constexpr double kPi = 3.14159265358979323846;

// The names of the movement settings, on StarterPlayer or on a Humanoid.
struct MoverNames {
  const char *walkSpeed, *jumpPower, *jumpHeight, *useJumpPower, *maxSlope;
};
constexpr MoverNames kStarterPlayer = {"CharacterWalkSpeed", "CharacterJumpPower",
                                       "CharacterJumpHeight", "CharacterUseJumpPower",
                                       "CharacterMaxSlopeAngle"};
constexpr MoverNames kHumanoid = {"WalkSpeed", "JumpPower", "JumpHeight", "UseJumpPower",
                                  "MaxSlopeAngle"};

void readMover(const Instance& from, const MoverNames& names, World& world) {
  world.walkSpeed = float(get<double>(from, names.walkSpeed));
  world.maxSlope = maxSlopeOf(get<double>(from, names.maxSlope));
}

InstanceId starterHumanoid(const Tree& tree, InstanceId player) {
  const InstanceId humanoid = tree.child(player, "StarterHumanoid");
  const bool is = humanoid != kNoInstance && tree.at(humanoid).className == "Humanoid";
  return is ? humanoid : kNoInstance;
}

void readHealthScript(const Tree& tree, InstanceId player, LevelDraft& level) {
  const InstanceId folder = tree.childOfClass(player, "StarterCharacterScripts");
  const InstanceId script = folder == kNoInstance ? kNoInstance : tree.child(folder, "Health");
  if (script == kNoInstance) return;
  const auto source = get<std::string>(tree.at(script), "Source");
  if (source.find("Health") == std::string::npos) {
    level.world.healthRegeneration = 0;
    return;
  }
  level.noteUnmodelled("custom Health script", tree, script,
                       "simulated with the default regeneration of 1 % of health per second");
}

// Returns the instance that enables the Character Controller Library for the player, or
// kNoInstance.
InstanceId controllerLibrary(const Tree& tree, InstanceId player) {
  const auto controller = get<EnumItem>(tree.at(player), "LuaCharacterController").value;
  if (controller != kControllerDefault && controller != kControllerLegacy) return player;
  for (InstanceId id = 0; id < tree.size(); ++id)
    if (tree.at(id).className == "AvatarAbilityRules" && tree.isUnder(id, player) &&
        get<EnumItem>(tree.at(id), "CharacterControllerMode").value != 0)
      return id;
  return kNoInstance;
}

// Notes settings of Workspace that affect where and how often characters are simulated.
void noteSimulation(const Tree& tree, InstanceId workspace, LevelDraft& level) {
  if (get<EnumItem>(tree.at(workspace), "AuthorityMode").value == kServerAuthority)
    level.noteUnmodelled("server authority", tree, workspace,
                         "the server moves the characters; simulated as if each player's own "
                         "machine moved them");
  if (get<EnumItem>(tree.at(workspace), "UseFixedSimulation").value != 0)
    level.noteIgnored("fixed simulation", tree.path(workspace),
                      "characters move at a fixed frequency at any frame rate; simulated "
                      "at 60 steps per second");
}

void noteCharacter(const Tree& tree, InstanceId player, LevelDraft& level) {
  if (const InstanceId says = controllerLibrary(tree, player); says != kNoInstance)
    level.noteUnmodelled("Character Controller Library", tree, says,
                         "the player is simulated as the classic Humanoid, which accelerates and "
                         "turns differently");
  const InstanceId custom = tree.child(player, "StarterCharacter");
  if (custom != kNoInstance)
    level.noteUnmodelled("custom character model", tree, custom,
                         "simulated as the standard body, with a hip height of 2 studs");
}

}  // namespace

float maxSlopeOf(double degrees) {
  return std::min(World{}.maxSlope, float(std::clamp(degrees, 0.0, 89.0) * kPi / 180.0));
}

float Jump::speed(float gravity) const {
  if (usesPower) return float(kJumpPowerGain * std::clamp(power, 0.0, 1000.0));
  return float(std::sqrt(2.0 * std::max(0.0, double(gravity)) * std::max(0.0, height)));
}

Jump jumpOf(const Tree& tree) {
  const InstanceId player = tree.service("StarterPlayer");
  if (player == kNoInstance) return {};
  const InstanceId humanoid = starterHumanoid(tree, player);
  const MoverNames& names = humanoid == kNoInstance ? kStarterPlayer : kHumanoid;
  const Instance& from = tree.at(humanoid == kNoInstance ? player : humanoid);
  return {get<bool>(from, names.useJumpPower), get<double>(from, names.jumpPower),
          get<double>(from, names.jumpHeight)};
}

void readWorld(const Tree& tree, LevelDraft& level) {
  World& world = level.world;
  const InstanceId workspace = tree.service("Workspace");
  if (workspace != kNoInstance) {
    world.gravity = float(get<double>(tree.at(workspace), "Gravity"));
    if (get<bool>(tree.at(workspace), "FallHeightEnabled"))
      world.fallenPartsHeight = float(get<double>(tree.at(workspace), "FallenPartsDestroyHeight"));
    else
      world.fallenPartsHeight = -50000;
    noteSimulation(tree, workspace, level);
  }
  world.jumpSpeed = jumpOf(tree).speed(world.gravity);
  const InstanceId player = tree.service("StarterPlayer");
  if (player == kNoInstance) return;
  readMover(tree.at(player), kStarterPlayer, world);
  if (const InstanceId humanoid = starterHumanoid(tree, player); humanoid != kNoInstance) {
    readMover(tree.at(humanoid), kHumanoid, world);
    world.maxHealth = float(std::max(1.0, get<double>(tree.at(humanoid), "MaxHealth")));
  }
  readHealthScript(tree, player, level);
  noteCharacter(tree, player, level);
  readAvatar(tree, level);
}

}  // namespace obby::importer
