#include "import/stages/numbers.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "engine/classes/class_defaults.h"
#include "import/document/words.h"
#include "import/stages/stage_words.h"

namespace obby::importer {
namespace {

constexpr const char* kNumberNames[] = {"Stage", "Checkpoint",       "Number",  "Index",
                                        "Order", "StageNumber",      "StageID", "CheckpointID",
                                        "Level", "CheckpointNumber", "ID"};

// Matches "Stage 3", "stage3_lava": its contents belong to that stage.
bool isStageName(std::string_view name) {
  const auto words = wordsOf(name);
  return words.size() > 1 && words[0] == "stage" && isWholeNumber(words[1]);
}

int numberInName(const Tree& tree, InstanceId id) {
  return firstNumber(tree.at(id).name).value_or(kUnnumbered);
}

void fill(int& number, int found) {
  if (number == kUnnumbered) number = found;
}

// Returns true for sources written for players: a number in free text ("4 Way Jump") is not an
// order.
bool isFreeText(NumberFrom from) { return from == NumberFrom::name || from == NumberFrom::team; }

// Returns true if a source tells checkpoints apart. A source with one number for all does not. Free
// text must number at least half of the checkpoints that have no number so far. NumberFrom::asked
// must give each a different number.
bool tells(NumberFrom from, const std::vector<int>& source, const std::vector<int>& numbers) {
  size_t open = 0, count = 0;
  std::set<int> values;
  for (size_t i = 0; i < source.size(); ++i) {
    if (numbers[i] != kUnnumbered) continue;
    ++open;
    if (source[i] == kUnnumbered) continue;
    ++count;
    values.insert(source[i]);
  }
  const bool isOneForAll = count > 1 && values.size() == 1 && open == source.size();
  if (from == NumberFrom::asked) return count > 1 && values.size() == count;
  return !isOneForAll && (!isFreeText(from) || 2 * count >= open);
}

}  // namespace

bool isWholeNumber(std::string_view name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
}

std::optional<int> asStage(double number) {
  constexpr double kMaxStage = 1e6;  // larger numbers are prices, times or ids
  if (!(number >= 0) || !(number < kMaxStage)) return {};
  return int(number);
}

int statedNumber(const Tree& tree, InstanceId id) {
  for (const char* name : kNumberNames)
    if (const auto number = tree.number(id, name))
      if (const auto stage = asStage(*number)) return *stage;
  return kUnnumbered;
}

void readNumbers(const Tree& tree, InstanceId owner, PartDraft& part) {
  StageSigns& signs = part.stageSigns;
  const InstanceId parent = tree.at(part.id).parent;
  const bool inModel = parent != kNoInstance && tree.at(parent).className == "Model";
  for (const InstanceId holder : {owner, part.id, inModel ? parent : part.id})
    fill(signs[NumberFrom::value], statedNumber(tree, holder));
  for (const InstanceId holder : {owner, part.id, inModel ? parent : part.id})
    fill(signs[NumberFrom::name], numberInName(tree, holder));
  for (InstanceId holder = part.id; holder != kNoInstance; holder = tree.at(holder).parent) {
    const std::string& name = tree.at(holder).name;
    const bool tells = isWholeNumber(name) || isStageName(name) || hasStageWord(kFolderWord, name);
    if (tells && holder != owner && holder != part.id)
      fill(signs[NumberFrom::folder], numberInName(tree, holder));
  }
}

std::map<int64_t, int> numbersOfTeams(const Tree& tree) {
  std::map<int64_t, int> numbers;
  const InstanceId teams = tree.service("Teams");
  if (teams == kNoInstance) return numbers;
  for (const InstanceId team : tree.at(teams).children)
    if (tree.at(team).className == "Team")
      numbers.emplace(get<int64_t>(tree.at(team), "TeamColor"), numberInName(tree, team));
  return numbers;
}

std::vector<int> numbersThatCount(const LevelDraft& level, const std::vector<int>& parts) {
  std::vector<int> numbers(parts.size(), kUnnumbered);
  for (size_t from = 0; from < kNumberSources; ++from) {
    std::vector<int> source;
    for (const int part : parts)
      source.push_back(level.parts[size_t(part)].stageSigns.numbers[from]);
    if (!tells(NumberFrom(from), source, numbers)) continue;
    for (size_t i = 0; i < source.size(); ++i) fill(numbers[i], source[i]);
  }
  return numbers;
}

}  // namespace obby::importer
