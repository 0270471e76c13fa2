// The point about which a model turns when a script pivots it.
#pragma once

#include "import/tree.h"

namespace obby::importer {

// A part's own frame; of a model its primary part's, else its stored pivot, else the centre of its
// parts. The identity for what has no place.
// PivotOffset is not in it.
Pose pivotOf(const Tree& tree, InstanceId id);

// The PrimaryPart of a model, if it is one of the parts below it; else kNoInstance.
InstanceId primaryPartOf(const Tree& tree, InstanceId id);

}  // namespace obby::importer
