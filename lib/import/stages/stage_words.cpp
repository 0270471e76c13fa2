#include "import/stages/stage_words.h"

#include <vector>

#include "import/document/words.h"

namespace obby::importer {
namespace {

struct StageWord {
  std::string_view word;
  unsigned roles;
};
constexpr StageWord kStageWordTable[] = {{"checkpoint", kFolderWord},
                                         {"checkpoints", kFolderWord | kRowWord},
                                         {"stages", kFolderWord | kRowWord},
                                         {"spawns", kFolderWord | kRowWord},
                                         {"spawnpoints", kFolderWord | kRowWord},
                                         {"respawns", kFolderWord | kRowWord},
                                         {"start", kStartWord | kSureStartWord},
                                         {"mapstart", kStartWord | kSureStartWord},
                                         {"inicio", kStartWord | kSureStartWord},
                                         {"lobby", kStartWord},
                                         {"spawn", kStartWord},
                                         {"win", kWinnersWord | kWinsWord},
                                         {"finished", kWinnersWord | kWinsWord},
                                         {"completed", kWinnersWord | kWinsWord},
                                         {"winner", kWinnersWord},
                                         {"winners", kWinnersWord},
                                         {"victory", kWinnersWord},
                                         {"finish", kWinnersWord},
                                         {"finishers", kWinnersWord},
                                         {"champions", kWinnersWord},
                                         {"victors", kWinnersWord},
                                         {"beaten", kWinnersWord},
                                         {"wins", kWinsWord},
                                         {"won", kWinsWord},
                                         {"victories", kWinsWord},
                                         {"completions", kWinsWord}};

}  // namespace

bool hasStageWord(WordRole role, std::string_view name) {
  std::vector<std::string_view> words;
  for (const StageWord& one : kStageWordTable)
    if (one.roles & role) words.push_back(one.word);
  return !firstWordIn(name, words).empty();
}

}  // namespace obby::importer
