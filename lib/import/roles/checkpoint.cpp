// Parts at which a player comes back. The stage is first the number that the maker gave, or
// kUnnumbered; checkpoints.cpp puts them in order afterwards.
#include <unordered_map>

#include "import/checkpoints.h"
#include "import/roles/role.h"
#include "import/words.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kCheckpointTags = {
    "checkpoint", "checkpoints", "stage", "stages", "spawnpoint", "respawn", "respawnpoint"};
constexpr std::string_view kWords[] = {"checkpoint", "checkpoints"};
constexpr std::string_view kFolderWords[] = {"checkpoint", "checkpoints", "stages", "spawns"};

void give(PartDraft& part, int stage, std::string reason, bool guessed) {
  if (part.checkpoint || part.kill) return;
  part.checkpoint = stage;
  part.evidence.push_back({"checkpoint", std::move(reason), guessed});
}

// "Checkpoint 3", "CheckPoint", "check_point": of a model that is one, not of a folder of them.
bool beginsAsCheckpoint(std::string_view name) {
  const auto words = wordsOf(name);
  return !words.empty() &&
         (words[0] == "checkpoint" || (words.size() > 1 && words[0] + words[1] == "checkpoint"));
}

bool isNumber(std::string_view name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
}

// "Stage 3", "stage3_lava": what is in it belongs to that stage.
bool isStage(std::string_view name) {
  const auto words = wordsOf(name);
  return words.size() > 1 && words[0] == "stage" && isNumber(words[1]);
}

bool inCheckpointFolder(const Tree& tree, InstanceId id) {
  const InstanceId parent = tree.at(id).parent;
  return parent != kNoInstance && !firstWordIn(tree.at(parent).name, kFolderWords).empty();
}

}  // namespace

int stageNumber(const Tree& tree, InstanceId id, InstanceId part) {
  for (InstanceId holder : {id, part})
    for (const char* name : {"Stage", "Checkpoint", "Number", "Index", "Order", "Level", "ID"})
      if (const auto number = tree.number(holder, name))
        if (*number >= 0 && *number < 1e6) return int(*number);
  for (InstanceId holder = part; holder != kNoInstance; holder = tree.at(holder).parent) {
    const std::string& name = tree.at(holder).name;
    const bool own = holder == id || holder == part;
    const bool tells =
        own || isNumber(name) || isStage(name) || !firstWordIn(name, kFolderWords).empty();
    const auto number = tells ? firstNumber(name) : std::nullopt;
    if (number) return *number;
  }
  return kUnnumbered;
}

void checkpointFromTags(RoleContext& context) {
  context.eachTagged(kCheckpointTags, [&](InstanceId id, const std::string& tag) {
    const auto giveOne = [&](InstanceId one) {
      PartDraft* part = touchPart(context, one);
      if (part) give(*part, stageNumber(context.tree, one, part->id), "tag " + tag, false);
    };
    // A folder holds checkpoints side by side, but for that of one stage. A model is one.
    if (context.tree.at(id).className != "Folder" || lower(tag) == "stage") return giveOne(id);
    for (InstanceId child : context.tree.at(id).children) giveOne(child);
  });
}

void checkpointFromNames(RoleContext& context) {
  const Tree& tree = context.tree;
  bool stated = false;
  for (const PartDraft& part : context.level.parts) stated = stated || part.checkpoint.has_value();
  if (stated) return;  // stated checkpoints make names needless
  std::unordered_map<InstanceId, const PartDraft*> touched;  // of each model
  for (size_t i = 0; i < context.level.parts.size(); ++i) {
    PartDraft& part = context.level.parts[i];
    const Instance& instance = tree.at(part.id);
    if (hasRole(part) || !part.touch || instance.className == "SpawnLocation") continue;
    const bool named = !firstWordIn(instance.name, kWords).empty();
    if (named || (isNumber(instance.name) && inCheckpointFolder(tree, part.id))) {
      give(part, stageNumber(tree, part.id, part.id), "name " + instance.name, true);
      continue;
    }
    // A model called like a checkpoint: one of its parts counts.
    const InstanceId model = instance.parent;
    if (model == kNoInstance || tree.at(model).className != "Model") continue;
    const std::string& name = tree.at(model).name;
    if (!beginsAsCheckpoint(name)) continue;
    const auto [known, isNew] = touched.try_emplace(model);
    if (isNew) known->second = touchPart(context, model);
    if (known->second == &part) give(part, stageNumber(tree, model, part.id), "name " + name, true);
  }
}

}  // namespace obby::importer
