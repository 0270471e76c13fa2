// Changes that scripts made once, at the start, become part of the document.
#pragma once

#include <map>

#include "engine/report.h"

namespace obby::importer {

// Appends the parts that scripts have made below Workspace. Returns their ids by those of the
// report.
std::map<InstanceId, InstanceId> addMadeParts(Document& document, const engine::Report& report);

// Sets properties and poses that scripts changed before the probes and never afterwards. Parts that
// are out of the world by then leave the tree.
void settle(Document& document, const engine::Report& report);

// Whether the part moves by itself after the start.
bool keepsMoving(const engine::Report& report, InstanceId part);

}  // namespace obby::importer
