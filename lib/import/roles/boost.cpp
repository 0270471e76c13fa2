// Finds parts that make a player walk faster or jump higher, by a kit's marker.
#include <algorithm>

#include "import/draft/world.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

constexpr double kMaxFactor = 100;
constexpr double kMaxSeconds = 3600;

std::optional<Boost> boostOf(const World& world, const std::string& type, double power) {
  Boost boost;
  const bool jumps = containsWord(type, "jump");
  const double factor =
      jumps ? kJumpPowerGain * power / double(world.jumpSpeed) : power / double(world.walkSpeed);
  if (!(factor > 0) || factor > kMaxFactor) return std::nullopt;
  (jumps ? boost.jumpSpeed : boost.walkSpeed) = float(factor);
  return boost;
}

}  // namespace

void boostFromMarkers(RoleContext& context) {
  const Tree& tree = context.tree;
  context.eachMarker([&](InstanceId marker, InstanceId owner) {
    PartDraft* part = context.part(owner);
    if (!part || part->boost || !containsWord(markerWords(tree, marker), "booster")) return;
    const auto power = tree.number(marker, "Power");
    const auto boost = boostOf(
        context.level.world, lower(tree.text(marker, "Type").value_or("Speed")), power.value_or(0));
    const std::string reason = "marker " + tree.at(marker).name;
    if (!boost) return context.level.noteUnmodelled("booster without a power", tree, owner, reason);
    part->boost = boost;
    part->boost->seconds =
        float(std::clamp(tree.number(marker, "Duration").value_or(0), 0.0, kMaxSeconds));
    part->evidence.push_back({"boost", reason, false});
  });
}

}  // namespace obby::importer
