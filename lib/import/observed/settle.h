// Changes that scripts made once, at the start, become part of the document.
#pragma once

#include <map>

#include "engine/report.h"

namespace obby::importer {

// Appends what scripts have made: parts below Workspace, joints, constraints and movers where they
// are. Returns their ids by those of the report.
std::map<InstanceId, InstanceId> addMadeParts(Document& document, const engine::Report& report);

// Sets properties and poses that scripts changed before the probes and never afterwards. Parts that
// are out of the world by then leave the tree.
void settle(Document& document, const engine::Report& report);

// Whether the part moves by itself after the start.
bool keepsMoving(const engine::Report& report, InstanceId part);

}  // namespace obby::importer
