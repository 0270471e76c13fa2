// Finds parts that hurt: instant kills and damage, by tag, tower-kit marker or name.
#include <algorithm>
#include <set>

#include "import/document/words.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

constexpr float kAll = 1e6f;          // more than any player's health
constexpr float kKitCooldown = 0.1f;  // seconds between two hits in tower kits before v6
constexpr float kKitCooldown6 = 1;    // seconds; the default of v6

struct DamageWord {
  std::string_view word;
  float damage;
};
// Damage per touch in tower kits, by word.
constexpr DamageWord kKitDamage[] = {
    {"kills", 5}, {"double", 10}, {"ouch", 20}, {"instakills", kAll}, {"instakill", kAll}};

const std::vector<std::string_view> kKillTags = {
    "killblock", "killbrick", "killpart", "kill",         "kill part",  "kill brick", "lava",
    "trappart",  "trap",      "deadly",   "hazard",       "death",      "deathbrick", "killzone",
    "spike",     "spikes",    "laser",    "obstaclekill", "killblocks", "killbricks", "killparts"};
const std::vector<std::string_view> kDamageTags = {"damage", "damagebrick", "damagepart",
                                                   "damageblock", "hurt"};
// Tags by which a designer overrides wrong guesses from a script or a name.
const std::vector<std::string_view> kHarmlessTags = {"harmless", "nokill", "nodamage"};
const std::vector<std::string_view> kHarmTags = {"kills", "double", "ouch", "instakills",
                                                 "instakill"};

constexpr std::string_view kKillWords[] = {
    "kill",   "kills",      "killer",    "killbrick", "killblock",  "killpart", "lava",
    "death",  "deadly",     "spike",     "spikes",    "hazard",     "laser",    "acid",
    "damage", "killbricks", "instakill", "killparts", "killblocks", "killzone", "hurt"};
constexpr std::string_view kDamageWords[] = {"damage", "hurt"};
constexpr float kGuessedDamage = 10;  // if a damage part states no damage
// Words that reverse the meaning of a kill word.
constexpr std::string_view kFriends[] = {"remover", "anti",  "no",    "safe",    "skill", "tool",
                                         "sign",    "label", "light", "counter", "script"};

// Returns true for a name with one of these whole words. "Bob's Kill Brick" has the words s and
// kill, not skill.
bool isFriend(std::string_view name) {
  const auto words = wordsOf(name);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return std::find(std::begin(kFriends), std::end(kFriends), word) != std::end(kFriends);
  });
}

// Words that may accompany a kill word in the name of a folder of kill parts.
constexpr std::string_view kPartWords[] = {"part",   "parts", "brick", "bricks", "block",
                                           "blocks", "floor", "the",   "all",    "folder"};

// Returns true for a folder called "KillParts", false for one called "StraightPiece_WithLava".
bool isKillFolder(const Instance& folder) {
  const auto words = wordsOf(folder.name);
  const auto in = [](const auto& list, const std::string& word) {
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
  };
  return !words.empty() && std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return in(kKillWords, word) || in(kPartWords, word);
  });
}

bool give(PartDraft& part, Kill kill, std::string reason, bool guessed) {
  if (part.kill || part.goal || part.checkpoint || hasEvidence(part, kHarmless)) return false;
  part.kill = kill;
  part.evidence.push_back({"kill", std::move(reason), guessed});
  return true;
}

std::optional<float> kitDamage(std::string_view word) {
  for (const auto& row : kKitDamage)
    if (row.word == word) return row.damage;
  return std::nullopt;
}

// Reads Damage and Cooldown from attributes or value objects next to the evidence.
Kill stated(const Tree& tree, InstanceId id, Kill fallback) {
  for (const char* name : {"Damage", "DamageAmount", "customDamage", "Amount"})
    if (const auto damage = tree.number(id, name)) {
      fallback.damage = std::clamp(float(*damage), 0.0f, kAll);
      break;
    }
  for (const char* name : {"Cooldown", "DamageCooldown", "Debounce"})
    if (const auto cooldown = tree.number(id, name)) {
      fallback.cooldown = std::clamp(float(*cooldown), 0.0f, 60.0f);
      break;
    }
  return fallback;
}

}  // namespace

void harmlessFromTags(RoleContext& context) {
  context.eachTagged(kHarmlessTags, [&](InstanceId id, const std::string& tag) {
    for (PartDraft* part : context.partsOf(id))
      if (!hasEvidence(*part, kHarmless))
        part->evidence.push_back({kHarmless, "tag " + tag, false});
  });
}

void killFromTags(RoleContext& context) {
  harmlessFromTags(context);
  const auto each = [&](const std::vector<std::string_view>& tags, auto kill) {
    context.eachTagged(tags, [&](InstanceId id, const std::string& tag) {
      const Kill all = stated(context.tree, id, kill(tag));
      for (PartDraft* part : context.partsOf(id)) give(*part, all, "tag " + tag, false);
    });
  };
  each(kKillTags, [](const std::string&) { return Kill{}; });
  each(kDamageTags, [](const std::string&) { return Kill{kGuessedDamage, 0}; });
  each(kHarmTags, [](const std::string& tag) {
    return Kill{kitDamage(lower(tag)).value_or(100.0f), kKitCooldown6};
  });
}

void killFromMarkers(RoleContext& context) {
  context.eachMarker([&](InstanceId marker, InstanceId owner) {
    PartDraft* part = context.part(owner);
    if (!part) return;
    const std::string words = markerWords(context.tree, marker);
    const std::string name = lower(context.tree.at(marker).name);
    if (const auto damage = kitDamage(name)) {
      give(*part, {*damage, kKitCooldown}, "marker " + context.tree.at(marker).name, false);
    } else if (containsWord(words, "damagebrick")) {
      const std::string type = lower(context.tree.text(marker, "Type").value_or("kills"));
      if (type == "heals") return;
      Kill kill = stated(context.tree, marker, {kitDamage(type).value_or(5.0f), kKitCooldown6});
      if (type != "custom") kill.damage = kitDamage(type).value_or(kill.damage);
      give(*part, kill, "marker " + context.tree.at(marker).name + " type " + type, false);
    }
  });
}

void killFromNames(RoleContext& context) {
  // If a script kills through some children of a folder, its other children are harmless.
  std::set<InstanceId> scripted;
  for (const auto& part : context.level.parts)
    for (const auto& evidence : part.evidence)
      if (evidence.role == "kill" && !evidence.guessed)
        scripted.insert(context.tree.at(part.id).parent);
  for (auto& part : context.level.parts) {
    if (!part.touch || hasRole(part)) continue;
    const Instance& instance = context.tree.at(part.id);
    const bool hasParent = instance.parent != kNoInstance;
    std::string from = instance.name;
    std::string word = firstWordIn(from, kKillWords);
    if (word.empty() && hasParent && isKillFolder(context.tree.at(instance.parent))) {
      from = context.tree.at(instance.parent).name;
      word = firstWordIn(from, kKillWords);
    }
    if (word.empty() || isFriend(from)) continue;
    if (context.scriptsTell) {
      context.level.noteIgnored("name that suggests a kill part", context.tree.path(part.id),
                                "no script makes it kill");
      continue;
    }
    if (from != instance.name && scripted.count(instance.parent)) {
      context.level.noteIgnored(
          "name that suggests a kill part", context.tree.path(part.id),
          "a script turns a sibling of this part into a kill part, but not this part");
      continue;
    }
    const bool damages = !firstWordIn(from, kDamageWords).empty();
    give(part, damages ? Kill{kGuessedDamage, 0} : Kill{}, "name " + from, true);
  }
}

}  // namespace obby::importer
