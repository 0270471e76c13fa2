// Roles are the effects of parts on a player. Each role is one file in this folder and one row in
// role_table.cpp. A row names the role's finder for each kind of evidence.
#pragma once

#include <string>

#include "import/draft/role_context.h"

namespace obby::importer {

using RoleFinder = void (*)(RoleContext&);

// One role and its finders, one for each kind of evidence; null where there is none. `fromNames`
// also covers defaults, velocities, stacks of parts and constraints.
struct RoleRow {
  const char* name;
  RoleFinder fromTags, fromMarkers, fromNames;
};

// Returns the words that identify a kit's Configuration or marker: its tags and its name, lower
// case.
std::string markerWords(const Tree& tree, InstanceId marker);

// Runs every finder, strongest evidence first: tags, markers, other evidence. A part that has a
// role keeps it against weaker evidence.
void findRoles(RoleContext& context);

// Returns the part that represents a tagged model or folder: the one called Touch, Goal, Hitbox or
// the like, else its primary part, else its first part. A part represents itself. Returns null if
// none of these parts is in the level.
PartDraft* touchPart(RoleContext& context, InstanceId id);

// The finders of each role file.
void harmlessFromTags(RoleContext&);
void killFromTags(RoleContext&);
void killFromMarkers(RoleContext&);
void killFromNames(RoleContext&);
void checkpointFromTags(RoleContext&);
void checkpointFromMarkers(RoleContext&);
void checkpointFromNames(RoleContext&);
// Finds checkpoints that share a numbered row with known checkpoints. A part counts if its
// listeners showed no effect so far, or if it lies in a folder of stages.
void checkpointFromSiblings(RoleContext&);
void goalFromTags(RoleContext&);
void goalFromNames(RoleContext&);
void conveyorFromTags(RoleContext&);
void conveyorFromMarkers(RoleContext&);
void conveyorFromVelocity(RoleContext&);
void jumpPadFromTags(RoleContext&);
void jumpPadFromMarkers(RoleContext&);
void boostFromMarkers(RoleContext&);
void oneWayFromTags(RoleContext&);
void oneWayFromMarkers(RoleContext&);
void vanishFromTags(RoleContext&);
void vanishFromMarkers(RoleContext&);
void seatFromClass(RoleContext&);
void ladderFromStacks(RoleContext&);
void movingFromRecordings(RoleContext&);
void movingFromTags(RoleContext&);
void movingFromMarkers(RoleContext&);
void movingFromConstraints(RoleContext&);

}  // namespace obby::importer
