// Makes changes that scripts made once, at the start, part of the document.
#pragma once

#include <map>
#include <set>

#include "engine/report.h"

namespace obby::importer {

// Appends the parts below Workspace that scripts made, and joints, constraints and movers at their
// places. Returns a map from report ids to document ids.
std::map<InstanceId, InstanceId> addMadeParts(Document& document, const engine::Report& report);

// Applies properties that scripts changed before the probes and never afterwards. Applies the poses
// at which parts stay or begin to move. Parts outside the world by then leave the tree, except
// those that a touch or use brings. Returns these exceptions.
std::set<InstanceId> settle(Document& document, const engine::Report& report);

// Returns true if scripts made the part after the first probes. `part` is its id in the document.
bool isMadeLater(const engine::Report& report, InstanceId part);

// Returns true if the part moves by itself. Placement at the start does not count.
bool movesByItself(const engine::Report& report, InstanceId part);

// Returns the part's pose before it begins to move.
Pose poseAtStart(const engine::Track& track, bool isMade);

}  // namespace obby::importer
