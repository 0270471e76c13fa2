// Notes instances whose function the level lacks.
#include "import/level/unmodelled.h"

#include <algorithm>
#include <set>

#include "engine/classes/class_defaults.h"
#include "import/document/words.h"

namespace obby::importer {
namespace {

// A word in names of parts whose role needs a number that the name does not state.
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

// Notes parts whose names suggest a function that nothing in the file implements. If any part with
// the same word in its name has a role, the others are decoration.
void noteNames(RoleContext& context) {
  std::set<std::string_view> kept;
  for (const PartDraft& part : context.level.parts)
    if (const auto* row = hasRole(part) ? tellingName(context.tree.at(part.id).name) : nullptr)
      kept.insert(row->word);
  for (const PartDraft& part : context.level.parts) {
    const auto* row = hasRole(part) ? nullptr : tellingName(context.tree.at(part.id).name);
    if (row && !kept.count(row->word))
      context.level.noteUnmodelled(
          row->kind, context.tree, part.id,
          "nothing in the file gives it a function; treated as a plain part");
  }
}

void noteInstances(RoleContext& context) {
  const Tree& tree = context.tree;
  for (const PartDraft& part : context.level.parts) {
    const Instance& instance = tree.at(part.id);
    if (instance.className == "VehicleSeat")
      context.level.noteUnmodelled(
          "vehicle seat", tree, part.id,
          "treated as a plain part; the simulated player does not sit in it");
    if (!hasRole(part) && !hasEvidence(part, kHarmless))
      for (const std::string& tag : instance.tags)
        context.level.noteIgnored("tag " + tag, tree.path(part.id),
                                  "the tag gives the part no role");
  }
  for (InstanceId id = 0; id < tree.size(); ++id)
    if (tree.at(id).className == "DragDetector")
      context.level.noteUnmodelled("part that players drag", tree, id,
                                   "the simulated player does not drag it");
    else if (isA(tree.at(id).className, "BackpackItem"))
      context.level.noteUnmodelled("tool", tree, id, "the simulated player has no tools");
}

// Kit tags that the simulator does not support, in lower case.
constexpr std::string_view kKitTags[] = {"buttonactivated", "pushbox",  "pushboxdestroyer",
                                         "zipline",         "trippart", "teleporter",
                                         "walljump",        "balloon",  "swing"};

void noteTags(RoleContext& context) {
  for (InstanceId id = 0; id < context.tree.size(); ++id)
    for (const std::string& tag : context.tree.at(id).tags)
      if (std::find(std::begin(kKitTags), std::end(kKitTags), lower(tag)) != std::end(kKitTags) &&
          context.hasParts(id))
        context.level.noteUnmodelled("tag " + lower(tag), context.tree, id,
                                     "treated as a plain part");
}

}  // namespace

void noteUnmodelled(RoleContext& context) {
  noteInstances(context);
  noteNames(context);
  noteTags(context);
}

}  // namespace obby::importer
