// Reads the numbers of checkpoints from a place and decides which of them count.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Returns true for digits such as "12".
bool isWholeNumber(std::string_view name);

// Returns the number as a stage, or nullopt if it is below 0 or too large.
std::optional<int> asStage(double number);

// Returns the number that an attribute or a value object of the instance states under a name such
// as Stage, or kUnnumbered.
int statedNumber(const Tree& tree, InstanceId id);

// Adds the numbers that the file states: in values and names of the tagged or named instance
// `owner` and of its touched part, and in the names of ancestor folders. A folder counts if it is
// one of stages or checkpoints ("Stages", "Stage 3 Lava"), or if its name is a number.
void readNumbers(const Tree& tree, InstanceId owner, PartDraft& part);

// Returns the numbers in the names of the teams, by colour. The first team of a colour counts.
std::map<int64_t, int> numbersOfTeams(const Tree& tree);

// Returns one number for each part: that of its strongest source, among the sources that tell the
// parts apart.
std::vector<int> numbersThatCount(const LevelDraft& level, const std::vector<int>& parts);

}  // namespace obby::importer
