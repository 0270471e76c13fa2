#include "import/roles/numbered_rows.h"

#include <algorithm>
#include <map>
#include <set>

#include "import/document/pivot.h"
#include "import/document/words.h"
#include "import/stages/numbers.h"
#include "import/stages/stage_words.h"

namespace obby::importer {
namespace {

constexpr size_t kFewParts = 4;  // max parts of a pad with decoration
constexpr std::string_view kPadNames[] = {"touch",      "hitbox", "trigger",    "pad",
                                          "checkpoint", "spawn",  "spawnpoint", "start"};

// Replaces numbers: "Stage 3" becomes "stage 0".
std::string withoutNumber(std::string_view name) {
  std::string text;
  for (const std::string& word : wordsOf(name)) text += (isWholeNumber(word) ? "0" : word) + " ";
  return text;
}

bool hasNumber(std::string_view name) { return firstNumber(name).has_value(); }

bool isRowFolder(const Tree& tree, InstanceId id) {
  return id != kNoInstance && hasStageWord(kRowWord, tree.at(id).name);
}

bool isSpawn(const Tree& tree, InstanceId id) { return tree.at(id).className == "SpawnLocation"; }

// Returns true if the part could be a pad: players can touch it, it does not kill or move, and it
// is not a goal or checkpoint yet.
bool canBePad(const PartDraft& part) {
  return part.touch && !part.kill && !part.motion && !part.goal && !part.checkpoint;
}

float distance(const PartDraft& a, const PartDraft& b) {
  return length(a.pose.position - b.pose.position);
}

class NumberedRows {
 public:
  explicit NumberedRows(RoleContext& context) : context_(context), tree_(context.tree) {}

  std::vector<RowMember> inFolder(InstanceId folder) {
    std::map<std::string, std::map<int, InstanceId>> rows;  // members by row and number
    for (const InstanceId child : tree_.at(folder).children)
      if (hasNumber(tree_.at(child).name) && context_.hasParts(child))
        rows[withoutNumber(tree_.at(child).name)].emplace(*firstNumber(tree_.at(child).name),
                                                          child);
    std::vector<RowMember> members;
    const bool holdsRows = isRowFolder(tree_, folder);
    for (const auto& [name, row] : rows)
      if ((holdsRows && row.size() > 1) || isWholeNumber(tree_.at(row.begin()->second).name))
        addRow(row, members);
    if (members.empty() && isCheckpoints(tree_.at(folder).name)) addAll(folder, members);
    return members;
  }

 private:
  static bool isCheckpoints(const std::string& name) {
    const auto words = wordsOf(name);
    return words == std::vector<std::string>{"checkpoints"} ||
           words == std::vector<std::string>{"check", "points"};
  }

  void addRow(const std::map<int, InstanceId>& row, std::vector<RowMember>& members) {
    const PartDraft* before = nullptr;
    for (const auto& [number, owner] : row) {
      PartDraft* const pad = padOf(owner, before);
      if (!pad) continue;
      members.push_back({owner, pad});
      before = pad;
    }
  }

  void addAll(InstanceId folder, std::vector<RowMember>& members) {
    for (const InstanceId child : tree_.at(folder).children)
      if (PartDraft* const pad = padOf(child, nullptr)) members.push_back({child, pad});
  }

  // Returns the pad, or null if a SpawnLocation or another checkpoint represents the stage.
  PartDraft* padOf(InstanceId owner, const PartDraft* before) {
    std::vector<PartDraft*> parts;
    for (PartDraft* part : context_.partsOf(owner)) {
      if (isSpawn(tree_, part->id) || part->checkpoint) return nullptr;
      if (canBePad(*part)) parts.push_back(part);
    }
    for (const std::string_view name : kPadNames)
      for (PartDraft* part : parts)
        if (lower(tree_.at(part->id).name) == name) return part;
    if (parts.empty()) return nullptr;
    if (parts.size() <= kFewParts || !before) {
      PartDraft* const primary = context_.part(primaryPartOf(tree_, owner));
      return primary && canBePad(*primary) ? primary : parts.front();
    }
    return *std::min_element(parts.begin(), parts.end(), [&](PartDraft* a, PartDraft* b) {
      return distance(*a, *before) < distance(*b, *before);
    });
  }

  RoleContext& context_;
  const Tree& tree_;
};

}  // namespace

std::string rowOf(const Tree& tree, InstanceId part) {
  const Instance& instance = tree.at(part);
  if (hasNumber(instance.name))
    return std::to_string(instance.parent) + "/" + withoutNumber(instance.name);
  if (statedNumber(tree, part) != kUnnumbered)
    return std::to_string(instance.parent) + "/" + instance.name;
  const InstanceId model = instance.parent;
  if (model == kNoInstance || !hasNumber(tree.at(model).name)) return {};
  return std::to_string(tree.at(model).parent) + "/" + withoutNumber(tree.at(model).name) + "/" +
         instance.name;
}

bool isInRowFolder(const Tree& tree, InstanceId part) {
  return hasNumber(tree.at(part).name) && isRowFolder(tree, tree.at(part).parent);
}

bool isBelowMover(const Tree& tree, InstanceId id) {
  constexpr std::string_view kMovers[] = {"movingplatform", "mover", "movingpart"};
  for (; id != kNoInstance; id = tree.at(id).parent)
    for (const std::string& tag : tree.at(id).tags)
      if (std::find(std::begin(kMovers), std::end(kMovers), lower(tag)) != std::end(kMovers))
        return true;
  return false;
}

std::vector<RowMember> rowsInStageFolders(RoleContext& context) {
  std::vector<RowMember> members;
  NumberedRows rows(context);
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    const Instance& folder = context.tree.at(id);
    const bool isFolder = folder.className == "Folder" || folder.className == "Model";
    if (!isFolder || !hasStageWord(kFolderWord, folder.name) || hasNumber(folder.name)) continue;
    if (isBelowMover(context.tree, id)) continue;
    const auto found = rows.inFolder(id);
    members.insert(members.end(), found.begin(), found.end());
  }
  return members;
}

}  // namespace obby::importer
