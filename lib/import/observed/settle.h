// Changes that scripts made once, at the start, become part of the document.
#pragma once

#include <map>
#include <set>

#include "engine/report.h"

namespace obby::importer {

// Appends what scripts have made: parts below Workspace, joints, constraints and movers where they
// are. Returns their ids by those of the report.
std::map<InstanceId, InstanceId> addMadeParts(Document& document, const engine::Report& report);

// Sets properties that scripts changed before the probes and never afterwards, and the poses at
// which parts stay or begin to move. Parts that are out of the world by then leave the tree, but
// for those that a touch or use brings, which are returned.
std::set<InstanceId> settle(Document& document, const engine::Report& report);

// Whether scripts have made the part after the first probes; its id is that of the document.
bool isMadeLater(const engine::Report& report, InstanceId part);

// Whether the part moves by itself, other than to be put in its place at the start.
bool movesByItself(const engine::Report& report, InstanceId part);

// The part's pose before it begins to move.
Pose poseAtStart(const engine::Track& track, bool isMade);

}  // namespace obby::importer
