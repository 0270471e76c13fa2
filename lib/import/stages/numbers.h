// The numbers of checkpoints: where they stand in a place, and which of them count.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// "12".
bool isWholeNumber(std::string_view name);

// The number as that of a stage; nullopt if it is too large for one, or below 0.
std::optional<int> asStage(double number);

// The number that an attribute or a value object of the instance states under a name such as
// Stage; kUnnumbered: none.
int statedNumber(const Tree& tree, InstanceId id);

// Fills in the numbers that the file states: in values and names of the tagged or named instance
// `owner` and of its touched part, and in the names of folders above. Those are folders of stages
// or checkpoints ("Stages", "Stage 3 Lava"), or have a number for a name.
void readNumbers(const Tree& tree, InstanceId owner, PartDraft& part);

// The numbers in the names of the teams, by their colours. The first team of a colour counts.
std::map<int64_t, int> numbersOfTeams(const Tree& tree);

// Returns for each of these parts the number that counts: that of its strongest source, among the
// sources that tell the parts apart.
std::vector<int> numbersThatCount(const LevelDraft& level, const std::vector<int>& parts);

}  // namespace obby::importer
