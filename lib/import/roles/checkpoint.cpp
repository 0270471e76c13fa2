// Finds parts at which a player respawns. Each gets the numbers that the file states for it;
// checkpoints.cpp puts them in order afterwards.
#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "import/document/words.h"
#include "import/roles/numbered_rows.h"
#include "import/roles/role.h"
#include "import/stages/numbers.h"

namespace obby::importer {
namespace {

constexpr std::string_view kCheckpointTags[] = {
    "checkpoint", "checkpoints", "stage", "stages", "spawnpoint", "respawn", "respawnpoint"};
constexpr std::string_view kWords[] = {"checkpoint", "checkpoints"};
constexpr std::string_view kPadWords[] = {"pad", "stage",   "level", "spawn",
                                          "cp",  "respawn", "save"};

bool give(RoleContext& context, PartDraft& part, InstanceId owner, std::string reason,
          bool guessed) {
  if (part.checkpoint || part.kill) return false;
  part.checkpoint = kUnnumbered;
  readNumbers(context.tree, owner, part);
  part.evidence.push_back({"checkpoint", std::move(reason), guessed});
  return true;
}

// Matches "Checkpoint 3", "CheckPoint", "check_point": a model that is one checkpoint, not a folder
// of them.
bool beginsAsCheckpoint(std::string_view name) {
  const auto words = wordsOf(name);
  return !words.empty() &&
         (words[0] == "checkpoint" || (words.size() > 1 && words[0] + words[1] == "checkpoint"));
}

// Returns a tag of checkpoints without its number ("Checkpoint_3" becomes "checkpoint"), or "".
std::string checkpointTag(const std::string& tag) {
  auto words = wordsOf(tag);
  if (words.size() > 1 && isWholeNumber(words.back())) words.pop_back();
  std::string joined;
  for (const std::string& word : words) joined += word;
  const bool isOne = std::find(std::begin(kCheckpointTags), std::end(kCheckpointTags), joined) !=
                     std::end(kCheckpointTags);
  return isOne ? joined : std::string();
}

void giveTagged(RoleContext& context, InstanceId id, const std::string& tag,
                const std::string& kind) {
  const auto giveOne = [&](InstanceId one) {
    PartDraft* const part = touchPart(context, one);
    if (part && give(context, *part, one, "tag " + tag, false))
      part->stageSigns[NumberFrom::tag] = firstNumber(tag).value_or(kUnnumbered);
  };
  // A folder holds several checkpoints, except the folder of a single stage. A model is one
  // checkpoint.
  if (context.tree.at(id).className != "Folder" || kind == "stage") return giveOne(id);
  for (const InstanceId child : context.tree.at(id).children) giveOne(child);
}

// Returns true if the place states its checkpoints other than by names.
bool areStated(const RoleContext& context) {
  int changing = 0;
  for (const PartDraft& part : context.level.parts) {
    if (part.checkpoint) return true;
    const Instance& instance = context.tree.at(part.id);
    if (instance.className == "SpawnLocation" &&
        propertyOr(instance, "AllowTeamChangeOnTouch", false))
      ++changing;
  }
  return changing > 1;
}

void giveNamed(RoleContext& context) {
  const Tree& tree = context.tree;
  std::unordered_map<InstanceId, const PartDraft*> touched;  // touched part of each model
  for (PartDraft& part : context.level.parts) {
    const Instance& instance = tree.at(part.id);
    if (hasRole(part) || !part.touch || instance.className == "SpawnLocation") continue;
    if (!firstWordIn(instance.name, kWords).empty() && !isBelowMover(tree, part.id)) {
      give(context, part, part.id, "name " + instance.name, true);
      continue;
    }
    // In a model with the name of a checkpoint, one part counts.
    const InstanceId model = instance.parent;
    if (model == kNoInstance || tree.at(model).className != "Model") continue;
    const std::string& name = tree.at(model).name;
    if (!beginsAsCheckpoint(name)) continue;
    const auto [known, isNew] = touched.try_emplace(model);
    if (isNew) known->second = touchPart(context, model);
    if (known->second == &part) give(context, part, model, "name " + name, true);
  }
}

bool isHeardOnly(const PartDraft& part) { return !hasRole(part) && part.heardOnly; }

// Makes checkpoints of pads that form a row and have listeners without a visible effect. Their
// scripts may keep the player's stage in a table.
void giveHeardRows(RoleContext& context) {
  std::map<std::string, std::vector<PartDraft*>> rows;
  for (PartDraft& part : context.level.parts) {
    if (!isHeardOnly(part)) continue;
    const std::string& name = context.tree.at(part.id).name;
    const std::string row = rowOf(context.tree, part.id);
    const bool tells = isWholeNumber(name) || !firstWordIn(row, kPadWords).empty();
    if (tells && !row.empty()) rows[row].push_back(&part);
  }
  for (const auto& [row, parts] : rows)
    if (parts.size() > 1)
      for (PartDraft* part : parts)
        give(context, *part, part->id,
             "one of several parts in a row, each with a script that handles its touch", true);
}

}  // namespace

void checkpointFromTags(RoleContext& context) {
  for (InstanceId id = 0; id < context.tree.size(); ++id)
    for (const std::string& tag : context.tree.at(id).tags) {
      const std::string kind = checkpointTag(tag);
      // A tag such as "Stage3" on several instances marks a whole stage.
      const bool isGroup =
          kind == "stage" && firstNumber(tag) && context.tree.tagged(tag).size() > 1;
      if (kind.empty() || isGroup) continue;
      giveTagged(context, id, tag, kind);
      break;
    }
}

// Makes checkpoints of several parts or models if each has its own number in a value called Stage
// or the like.
void checkpointFromMarkers(RoleContext& context) {
  constexpr const char* kNames[] = {"Stage", "Checkpoint", "StageNumber", "CheckpointNumber"};
  if (areStated(context)) return;
  std::map<int, std::vector<InstanceId>> owners;
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    const bool isOwner = context.tree.isPart(id) || context.tree.at(id).className == "Model";
    if (!isOwner || !context.hasParts(id)) continue;
    for (const char* name : kNames)
      if (const auto number = context.tree.number(id, name); number && asStage(*number)) {
        owners[*asStage(*number)].push_back(id);
        break;
      }
  }
  const bool isRow = std::all_of(owners.begin(), owners.end(),
                                 [](const auto& one) { return one.second.size() == 1; });
  if (owners.size() < 2 || !isRow) return;
  for (const auto& [number, ids] : owners)
    if (PartDraft* const part = touchPart(context, ids[0]); part && part->touch)
      give(context, *part, ids[0], "it has a stage number of its own", true);
}

void checkpointFromNames(RoleContext& context) {
  if (areStated(context)) return;  // stated checkpoints rule out guesses from names
  giveNamed(context);
  for (const RowMember& member : rowsInStageFolders(context))
    give(context, *member.part, member.owner, "name " + context.tree.at(member.owner).name, true);
  if (!areStated(context)) giveHeardRows(context);
}

void checkpointFromSiblings(RoleContext& context) {
  const Tree& tree = context.tree;
  std::set<std::string> rows;
  for (const PartDraft& part : context.level.parts)
    if (part.checkpoint) rows.insert(rowOf(tree, part.id));
  rows.erase("");
  for (PartDraft& part : context.level.parts) {
    const bool isOpen = !hasRole(part) && part.touch && !part.checkpoint;
    if (!isOpen || !(isHeardOnly(part) || isInRowFolder(tree, part.id))) continue;
    if (rows.contains(rowOf(tree, part.id)))
      give(context, part, part.id, "numbered like the other checkpoints of its row", true);
  }
}

}  // namespace obby::importer
