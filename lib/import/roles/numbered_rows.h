// Finds siblings whose names differ only in a number: "Stage1", "Stage2", ...
#pragma once

#include <string>
#include <vector>

#include "import/draft/role_context.h"

namespace obby::importer {

// Returns a text that the parts of one row share: the folder, and the names without their numbers.
// The number may be in the part's own name, in a value below the part or in the name of its model.
// Returns "" if the part has no number.
std::string rowOf(const Tree& tree, InstanceId part);

// Returns true if the part has a number and its parent is a folder called Stages, Checkpoints or
// the like.
bool isInRowFolder(const Tree& tree, InstanceId part);

// Returns true if a tag says that an ancestor moves. A part called checkpoint there is a waypoint
// of the motion.
bool isBelowMover(const Tree& tree, InstanceId id);

struct RowMember {
  InstanceId owner = kNoInstance;  // the instance whose name has the number
  PartDraft* part = nullptr;
};

// Returns the pads of the rows in folders called Stages, Checkpoints or the like. In a model or
// folder without a part made for touching, the part nearest to the previous pad counts. In a folder
// called Checkpoints without a row, each part is one.
std::vector<RowMember> rowsInStageFolders(RoleContext& context);

}  // namespace obby::importer
