// Finds the point about which a model turns when a script pivots it.
#pragma once

#include "import/document/tree.h"

namespace obby::importer {

// Returns a part's own frame. For a model, returns the frame of its primary part, else its stored
// pivot, else the centre of its parts. Returns the identity if the instance has no position.
// PivotOffset is not included.
Pose pivotOf(const Tree& tree, InstanceId id);

// Returns the PrimaryPart of a model if it is a part below the model, else kNoInstance.
InstanceId primaryPartOf(const Tree& tree, InstanceId id);

}  // namespace obby::importer
