// Finds words about stages in names.
#pragma once

#include <string_view>

namespace obby::importer {

enum WordRole : unsigned {
  kFolderWord = 1,     // a folder of stages or checkpoints, or of the parts of one checkpoint
  kRowWord = 2,        // a folder whose children are pads, one after the other
  kStartWord = 4,      // a place where players begin
  kSureStartWord = 8,  // a start, preferred among several spawns
  kWinnersWord = 16,   // a team, folder or pad of players who have finished
  kWinsWord = 32,      // a number or flag of the player that says that it has finished
};

// Returns true if a word of the name, or two of them together, has the role.
bool hasStageWord(WordRole role, std::string_view name);

}  // namespace obby::importer
