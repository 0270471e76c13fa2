// Finds parts that throw a player: by tag or kit marker.
#include "import/roles/role.h"
#include "import/roles/surface_speed.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kJumpPadTags = {
    "bouncepad",  "jumppad", "trampoline",  "bounce",   "launchpad",  "jumppads",
    "bouncepads", "bouncer", "trampolines", "jump pad", "bounce pad", "launcher"};
constexpr const char* kPowerNames[] = {"BounceImpulse", "BounceSpeed", "BouncePower", "JumpPower",
                                       "Power",         "LaunchPower", "Force",       "Strength",
                                       "Velocity",      "Impulse"};
constexpr float kDefaultPower = 100;
constexpr float kMaxPower = 2000;
constexpr double kDefaultElevator = 20;  // studs/s

std::optional<double> powerOf(const Tree& tree, InstanceId id) {
  for (const char* name : kPowerNames)
    if (const auto power = tree.number(id, name)) return power;
  return std::nullopt;
}

// Makes an elevator: a field that moves players upward for as long as they touch it.
void giveElevator(RoleContext& context, InstanceId marker, InstanceId owner) {
  PartDraft* part = context.part(owner);
  const auto speed = context.tree.number(marker, "Speed");
  if (!part || part->solid) return;
  giveJumpPad(*part, {part->pose.rotation.y * float(speed.value_or(kDefaultElevator)), true},
              "marker " + context.tree.at(marker).name, !speed);
}

}  // namespace

void giveJumpPad(PartDraft& part, JumpPad pad, std::string reason, bool guessed) {
  const float speed = length(pad.velocity);
  if (part.jumpPad || !(speed >= kMinSpeed) || speed > kMaxPower) return;
  part.jumpPad = pad;
  part.evidence.push_back({"jumpPad", std::move(reason), guessed});
}

void jumpPadFromTags(RoleContext& context) {
  context.eachTagged(kJumpPadTags, [&](InstanceId id, const std::string& tag) {
    const auto stated = powerOf(context.tree, id);
    for (PartDraft* part : context.partsOf(id)) {
      const auto own = powerOf(context.tree, part->id);
      const double power = own ? *own : stated.value_or(kDefaultPower);
      giveJumpPad(*part, {part->pose.rotation.y * float(power), true}, "tag " + tag,
                  !own && !stated);
    }
  });
}

void jumpPadFromMarkers(RoleContext& context) {
  context.eachMarker([&](InstanceId marker, InstanceId owner) {
    const std::string words = markerWords(context.tree, marker);
    if (containsWord(words, "elevator")) return giveElevator(context, marker, owner);
    if (!containsWord(words, "bouncepad") && !containsWord(words, "jumppad") &&
        !containsWord(words, "trampoline"))
      return;
    PartDraft* part = context.part(owner);
    if (!part) return;
    const auto power = powerOf(context.tree, marker);
    const float speed = float(power.value_or(kDefaultPower));
    const bool relative = context.tree.flag(marker, "RelativeForce").value_or(false);
    const Vec3 velocity = relative ? -part->pose.rotation.x * speed : Vec3{0, speed, 0};
    giveJumpPad(*part, {velocity, true}, "marker " + context.tree.at(marker).name, !power);
  });
}

}  // namespace obby::importer
