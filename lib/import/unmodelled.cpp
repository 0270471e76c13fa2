// The list of what is lost, by looking at instances and at the script readings.
#include "import/unmodelled.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/classes/class_defaults.h"
#include "import/classes.h"
#include "import/onset.h"
#include "import/scripted_changes.h"
#include "import/unread_code.h"
#include "import/words.h"

namespace obby::importer {
namespace {

// Names of things that would need a number which a name does not tell.
struct TellingName {
  std::string_view word;
  const char* kind;
};
constexpr TellingName kTellingNames[] = {{"conveyor", "name that suggests a conveyor"},
                                         {"trampoline", "name that suggests a jump pad"},
                                         {"jumppad", "name that suggests a jump pad"},
                                         {"bouncepad", "name that suggests a jump pad"},
                                         {"teleporter", "name that suggests a teleporter"},
                                         {"spinner", "name that suggests a spinner"},
                                         {"spinning", "name that suggests a spinner"},
                                         {"elevator", "name that suggests a mover"},
                                         {"moving", "name that suggests a mover"},
                                         {"disappearing", "name that suggests a vanishing part"}};

const TellingName* tellingName(const std::string& name) {
  const auto words = wordsOf(name);
  for (size_t i = 0; i < words.size(); ++i)
    for (const TellingName& row : kTellingNames) {
      const bool pair = i + 1 < words.size() && words[i] + words[i + 1] == row.word;
      if (words[i] == row.word || pair) return &row;
    }
  return nullptr;
}

// Parts whose names promise something that nothing in the file does. Where another part of such a
// name has its role the rest is decoration.
void noteNames(RoleContext& context) {
  std::set<std::string_view> kept;
  for (const PartDraft& part : context.level.parts)
    if (const auto* row = hasRole(part) ? tellingName(context.tree.at(part.id).name) : nullptr)
      kept.insert(row->word);
  for (const PartDraft& part : context.level.parts) {
    const auto* row = hasRole(part) ? nullptr : tellingName(context.tree.at(part.id).name);
    if (row && !kept.count(row->word))
      context.level.noteUnmodelled(
          row->kind, context.tree.path(part.id),
          "nothing in the file says what it does; treated as a plain part");
  }
}

void noteInstances(RoleContext& context) {
  const Tree& tree = context.tree;
  for (const PartDraft& part : context.level.parts) {
    const Instance& instance = tree.at(part.id);
    if (instance.className == "VehicleSeat")
      context.level.noteUnmodelled("vehicle seat", tree.path(part.id),
                                   "treated as a plain part: players do not sit in it");
    if (!hasRole(part) && !hasEvidence(part, kHarmless))
      for (const std::string& tag : instance.tags)
        context.level.noteIgnored("tag " + tag, tree.path(part.id), "not a tag that gives a role");
  }
  for (InstanceId id = 0; id < tree.size(); ++id)
    if (isA(tree.at(id).className, "BackpackItem"))
      context.level.noteUnmodelled("tool", tree.path(id), "the simulated player has no tools");
}

// Kit tags whose meaning the simulator has no room for, lower case.
constexpr std::string_view kKitTags[] = {
    "onewayplatform", "buttonactivated", "pushbox",  "pushboxdestroyer", "zipline",
    "trippart",       "teleporter",      "walljump", "balloon",          "swing"};

void noteTags(RoleContext& context) {
  for (InstanceId id = 0; id < context.tree.size(); ++id)
    for (const std::string& tag : context.tree.at(id).tags)
      if (std::find(std::begin(kKitTags), std::end(kKitTags), lower(tag)) != std::end(kKitTags) &&
          context.hasParts(id))
        context.level.noteUnmodelled("tag " + tag, context.tree.path(id),
                                     "treated as a plain part");
}

// What a touch does that no role covers: a kind and what is lost.
struct Effect {
  const char* kind;
  const char* note;
};

// Of what a touch or click changes of parts: of the touched one what no role has, and of others.
std::optional<Effect> changeOf(RoleContext& context, const Timeline& timeline,
                               const ScriptEvent& event) {
  const Effect button = {"button", "the parts that touching it changes stay as they are"};
  if (!context.hasParts(event.target)) {
    if (comesBack(event) && !context.tree.partsOf(event.target).empty()) return button;
    return std::nullopt;
  }
  if (isSize(event))
    return Effect{"size that a script changes", "stays as it is at the start of play"};
  if (event.kind == EventKind::tween) return std::nullopt;  // a motion, or only seen
  if (event.property == "Parent" && event.kind == EventKind::set && !event.flag)
    return Effect{"part that a script may change", "it is not known whether it stays in the world"};
  const PartDraft* part = context.part(event.target);
  const bool drives = event.property == "Velocity" || event.property == "RotVelocity";
  if (drives && part && part->anchored)
    return Effect{"conveyor that a script changes", "keeps its velocity at the start of play"};
  if (event.target == timeline.touched) return std::nullopt;
  if (event.kind == EventKind::destroy || event.property == "CanCollide" ||
      event.property == "CanTouch" || event.property == "Anchored")
    return button;
  return std::nullopt;
}

// Whether no harm is lost: a tag says that it does none, or it kills by other evidence.
bool isSettled(RoleContext& context, InstanceId id) {
  const PartDraft* part = context.part(id);
  const bool kills = part && part->kill && part->kill->damage >= context.level.world.maxHealth;
  return kills || (part && hasEvidence(*part, kHarmless));
}

// Whether the height that it gives is computed, so that the part throws nobody. Not where it keeps
// what a body has upward, and pushes along.
bool isLostPush(RoleContext& context, const Timeline& timeline, const Vec3& push) {
  const auto gives = [](float v) { return !std::isnan(v) && v != 0; };
  const PartDraft* touched = context.part(timeline.touched);
  return std::isnan(push.y) && !gives(push.x) && !gives(push.z) && !(touched && touched->jumpPad);
}

std::optional<Effect> effectOf(RoleContext& context, const Timeline& timeline,
                               const ScriptEvent& event) {
  switch (event.kind) {
    case EventKind::teleport: {
      const PartDraft* touched = context.part(timeline.touched);
      if (touched && touched->teleport) return std::nullopt;
      return Effect{"teleporter", "players who touch it are not moved"};
    }
    case EventKind::build:
      return Effect{"parts that a script builds",
                    "they are not in the file, so the level lacks them"};
    case EventKind::push:
      if (!event.vector || isLostPush(context, timeline, *event.vector))
        return Effect{"push that a script computes", "the push is left out"};
      return std::nullopt;
    case EventKind::character:
      if (event.property == "WalkSpeed" || event.property == "JumpPower" ||
          event.property == "JumpHeight" || event.property == "Gravity")
        return Effect{"speed or jump booster", "the player's speed and jump stay as they are"};
      if (event.property == "Health" && !isSettled(context, timeline.touched))
        return Effect{"damage that a script computes", "players take no damage"};
      if (event.property == "Sit" || event.property == "PlatformStand")
        return Effect{"trip part", "players stay on their feet"};
      return std::nullopt;
    case EventKind::set:
    case EventKind::tween:
    case EventKind::destroy: return changeOf(context, timeline, event);
    default: return std::nullopt;
  }
}

// Harm by something that the text does not tell: the handler of a touch of an unknown part, or a
// loop that looks for players by itself, be it once another script has enabled its own.
void noteHarm(RoleContext& context, const ScriptReading& reading, const Timeline& timeline) {
  const bool ownText = reading.isWoken() && timeline.line == 0;  // and no handler
  if (!ownText && !timeline.byItself() && !timeline.ofUnknownTouch()) return;
  for (const ScriptEvent& event : timeline.events) {
    if (!event.harms() || event.target != kNoInstance) continue;
    context.level.noteUnmodelled(
        "damage by an unknown part", context.tree.path(reading.script),
        "no part deals it; " + scriptReason(context.tree, reading, event.line));
    return;
  }
}

// Of roles whose times follow from waits that the text does not tell.
void noteWaits(RoleContext& context, const ScriptReading& reading, const Timeline& timeline) {
  if (!timeline.vague) return;
  std::set<InstanceId> seen;
  for (const ScriptEvent& event : timeline.events) {
    const bool counts = timeline.byItself() || event.target == timeline.touched;
    if (!counts || !changesParts(context.tree, event) || event.property == "Transparency") continue;
    if (!seen.insert(event.target).second) continue;
    for (const PartDraft* part : context.partsOf(event.target))
      if (part->vanish || part->motion)
        context.level.noteUnmodelled(
            "wait that a script computes", context.tree.path(part->id),
            "taken as the shortest possible wait, a tween as one second; " +
                scriptReason(context.tree, reading, event.line));
  }
}

// What scripts turn by its joint, as with Weld.C0 in a loop.
void noteJoints(RoleContext& context, const ScriptReading& reading) {
  std::set<InstanceId> seen;
  for (const Timeline& timeline : reading.timelines)
    for (size_t i = 0; i < timeline.events.size(); ++i) {
      const ScriptEvent& event = timeline.events[i];
      const bool atStart = timeline.trigger == Trigger::start && event.kind == EventKind::set &&
                           event.time <= 0 && !isLooped(timeline, i);
      if (event.target == kNoInstance || atStart) continue;
      if (!isRigidJointClass(context.tree.at(event.target).className)) continue;
      const bool moves = event.property == "C0" || event.property == "C1" ||
                         event.property == "Transform" || event.property == "DesiredAngle";
      if (!moves || !seen.insert(event.target).second) continue;
      const JointEnds ends = jointEnds(context.tree, event.target);
      if (ends.second != kNoInstance && context.part(ends.second))
        context.level.noteUnmodelled(
            "joint that a script turns", context.tree.path(event.target),
            "the joined part keeps its place; " + scriptReason(context.tree, reading, event.line));
    }
}

void noteTimelines(RoleContext& context, const ScriptReading& reading) {
  for (const Timeline& timeline : reading.timelines) {
    noteHarm(context, reading, timeline);
    noteWaits(context, reading, timeline);
    std::set<std::string> kinds;
    bool understood = false;
    for (const ScriptEvent& event : timeline.events) {
      understood = true;
      // First of all: loops have thousands of events.
      const bool byTouch = timeline.trigger == Trigger::touch || timeline.trigger == Trigger::other;
      if (!byTouch && event.kind != EventKind::build) continue;
      const auto effect = effectOf(context, timeline, event);
      if (!effect || !kinds.insert(effect->kind).second) continue;
      const InstanceId where = timeline.touched == kNoInstance ? reading.script : timeline.touched;
      if (timeline.touched == kNoInstance && event.kind != EventKind::build &&
          event.kind != EventKind::set && event.kind != EventKind::tween &&
          event.kind != EventKind::destroy)
        continue;  // what joining or dying does to a player is no part of a level
      context.level.noteUnmodelled(
          effect->kind, context.tree.path(where),
          std::string(effect->note) + "; " + scriptReason(context.tree, reading, event.line));
    }
    const PartDraft* touched = context.part(timeline.touched);
    if (timeline.trigger == Trigger::touch && !understood && touched && !hasRole(*touched))
      context.level.noteUnmodelled("unknown script pattern", context.tree.path(timeline.touched),
                                   "what a touch does was not understood; " +
                                       scriptReason(context.tree, reading, timeline.line));
  }
}

}  // namespace

void noteUnmodelled(RoleContext& context) {
  noteInstances(context);
  noteNames(context);
  noteTags(context);
  for (const ScriptReading& reading : context.scripts) {
    noteUnread(context, reading);
    noteTimelines(context, reading);
    noteJoints(context, reading);
  }
  noteScriptedChanges(context);
}

}  // namespace obby::importer
