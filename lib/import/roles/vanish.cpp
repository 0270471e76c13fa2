// Finds parts that lose their collision for a while, by tag or kit marker.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/roles/role.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kVanishTags = {"disappearing",    "disappearingplatform",
                                                   "disappear",       "fadingplatform",
                                                   "fading",          "vanish",
                                                   "vanishing",       "fadeplatform",
                                                   "vanisher",        "disappearingpart",
                                                   "fallingplatform", "falling"};
constexpr float kDefaultDelay = 1, kDefaultAway = 3;
constexpr float kKitFade = 2, kKitAway = 1;        // seconds; tower kits before v6
constexpr float kKit6Blink = 0.2f, kKit6Away = 2;  // seconds; v6 blinks three times
constexpr double kKit6Count = 3;

void give(PartDraft& part, Vanish vanish, std::string reason, bool guessed) {
  if (part.vanish) return;
  vanish.delay = std::min(vanish.delay, kGone);
  vanish.away = std::min(vanish.away, kGone);
  part.vanish = vanish;
  part.evidence.push_back({"vanish", std::move(reason), guessed});
}

// Returns the first of the named numbers that is not negative.
std::optional<double> firstOf(const Tree& tree, InstanceId id,
                              std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto number = tree.number(id, name); number && *number >= 0) return number;
  return std::nullopt;
}

std::optional<double> delayOf(const Tree& tree, InstanceId id) {
  return firstOf(tree, id, {"FadeTime", "Delay", "DisappearDelay", "DisappearTime", "Time"});
}
std::optional<double> awayOf(const Tree& tree, InstanceId id) {
  return firstOf(tree, id,
                 {"RespawnTime", "ReturnTime", "ReappearTime", "AwayTime", "Cooldown", "OffTime"});
}

}  // namespace

void vanishFromTags(RoleContext& context) {
  context.eachTagged(kVanishTags, [&](InstanceId id, const std::string& tag) {
    const auto delay = delayOf(context.tree, id), away = awayOf(context.tree, id);
    for (PartDraft* part : context.partsOf(id)) {
      const auto ownDelay = delayOf(context.tree, part->id),
                 ownAway = awayOf(context.tree, part->id);
      Vanish vanish;
      vanish.delay = float(ownDelay ? *ownDelay : delay.value_or(kDefaultDelay));
      vanish.away = float(ownAway ? *ownAway : away.value_or(kDefaultAway));
      give(*part, vanish, "tag " + tag, !(delay || ownDelay) || !(away || ownAway));
    }
  });
}

void vanishFromMarkers(RoleContext& context) {
  const Tree& tree = context.tree;
  std::set<InstanceId> known;  // owners; the first of several markers counts
  context.eachMarker([&](InstanceId marker, InstanceId owner) {
    const bool vanisher = containsWord(markerWords(tree, marker), "vanisher");
    if (!vanisher && lower(tree.at(marker).name) != "fadetime") return;
    if (!known.insert(owner).second) return;
    Vanish vanish;
    if (vanisher) {
      const auto blinks = firstOf(tree, marker, {"BlinkCount"}).value_or(kKit6Count);
      vanish.delay = float(blinks) * kKit6Blink;
      vanish.away = float(firstOf(tree, marker, {"RespawnTime"}).value_or(kKit6Away));
    } else {
      vanish.delay = float(firstOf(tree, owner, {"FadeTime"}).value_or(kKitFade));
      vanish.away = float(firstOf(tree, owner, {"RespawnTime"}).value_or(kKitAway));
    }
    const std::string reason = "marker " + tree.at(marker).name;
    for (PartDraft* part : context.partsOf(owner))
      if (part->solid) give(*part, vanish, reason, false);
  });
}

}  // namespace obby::importer
