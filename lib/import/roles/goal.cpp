// Finds where the level ends: by tag or name. Level designers share no convention.
#include <algorithm>
#include <iterator>

#include "import/document/words.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kGoalTags = {"goal",    "finish",  "finishline", "win",
                                                 "winpad",  "winpart", "winbrick",   "end",
                                                 "victory", "endpart", "finishpart"};
constexpr std::string_view kGoalWords[] = {"win",        "winpad",   "winner",  "finish",
                                           "finishline", "goal",     "victory", "chegada",
                                           "winpart",    "winbrick", "endpad",  "mapfinish"};
constexpr std::string_view kEndNames[] = {"end",      "theend",     "endpart",
                                          "endbrick", "exitregion", "exitblock"};

// Returns true if the whole name is one of these, however its words are joined: "TheEnd", "The
// End".
bool isEnd(std::string_view name) {
  std::string joined;
  for (const std::string& word : wordsOf(name)) joined += word;
  return std::find(std::begin(kEndNames), std::end(kEndNames), joined) != std::end(kEndNames);
}

}  // namespace

void goalFromTags(RoleContext& context) {
  context.eachTagged(kGoalTags, [&](InstanceId id, const std::string& tag) {
    const auto give = [&](PartDraft* part) {
      if (!part || part->goal) return;
      part->goal = 0;
      part->evidence.push_back({"goal", "tag " + tag, false});
    };
    // A folder holds several goals. A model is one goal. Each goal is a query of its own.
    if (context.tree.at(id).className != "Folder") return give(touchPart(context, id));
    for (PartDraft* part : context.partsOf(id)) give(part);
  });
}

void goalFromNames(RoleContext& context) {
  for (const auto& part : context.level.parts)
    if (part.goal) return;  // stated goals rule out guesses
  for (auto& part : context.level.parts) {
    const Instance& instance = context.tree.at(part.id);
    if (!part.touch || part.kill || instance.className == "SpawnLocation") continue;
    if (firstWordIn(instance.name, kGoalWords).empty() && !isEnd(instance.name)) continue;
    part.goal = 0;
    part.evidence.push_back({"goal", "name " + instance.name, true});
  }
}

}  // namespace obby::importer
