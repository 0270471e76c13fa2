// The numbers of checkpoints: where they stand in a place, and which of them count.
#pragma once

#include <map>
#include <vector>

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// "Stages", "Checkpoints", "Spawns".
bool isStageFolderName(std::string_view name);
// "12".
bool isWholeNumber(std::string_view name);

// The number that an attribute or a value object of the instance states under a name such as
// Stage; kUnnumbered: none.
int statedNumber(const Tree& tree, InstanceId id);

// Fills in what the file says: values and names of the tagged or named instance `owner` and of its
// touched part, folders above of stages or checkpoints ("Stages", "Stage 3 Lava") or called by
// nothing but a number.
void readNumbers(const Tree& tree, InstanceId owner, PartDraft& part);

// The numbers in the names of the teams, by their colours; of teams of one colour the first counts.
std::map<int64_t, int> numbersOfTeams(const Tree& tree);

// For each of these parts the number that counts: that of its strongest source, among the sources
// that tell the parts apart.
std::vector<int> numbersThatCount(const LevelDraft& level, const std::vector<int>& parts);

}  // namespace obby::importer
