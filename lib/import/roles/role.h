// Roles: what a part does to a player. Each role is one file in this folder and one row in
// role_table.cpp; a row names how the role shows itself in each kind of evidence.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "import/assemblies.h"
#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Poses and ticks of motions, see motion.h.
struct MotionRoom {
  size_t keys = 0, ticks = 0;
};

// What the role finders read and write.
class RoleContext {
 public:
  RoleContext(const Tree& tree, const Assemblies& assemblies, LevelDraft& level);

  const Tree& tree;
  const Assemblies& assemblies;
  LevelDraft& level;
  // Every script of the place ran without an error: what none of them makes deadly is harmless.
  bool scriptsTell = false;
  // Taken so far by parts that a player can meet, and by parts that had no role yet.
  MotionRoom metRoom, unmetRoom;
  std::vector<InstanceId> unmetMoving;  // those that move
  // Those without room, and why they would move.
  std::map<InstanceId, std::string> unmetStill;

  // The draft of a part instance; null if it is not in the level.
  PartDraft* part(InstanceId id);
  // Drafts of the part itself, or of every level part below a model or folder.
  std::vector<PartDraft*> partsOf(InstanceId id);
  // Whether partsOf gives any, at less cost.
  bool hasParts(InstanceId id);
  // Calls `visit` for every instance with one of the tags (any case), once, with the first that it
  // has, as the file writes it.
  void eachTagged(const std::vector<std::string_view>& tags,
                  const std::function<void(InstanceId, const std::string& tag)>& visit) const;
  // Calls `visit` with every marker child that a tower kit may hang below a part or model: value
  // objects and Configurations, and the instance that it marks.
  void eachMarker(const std::function<void(InstanceId marker, InstanceId owner)>& visit) const;

 private:
  std::unordered_map<InstanceId, size_t> index_;
  std::unordered_map<InstanceId, bool> holders_;  // what hasParts was asked for: scripts ask often
};

using RoleFinder = void (*)(RoleContext&);

// One role: its finders, one for each kind of evidence; null where that kind says nothing.
struct RoleRow {
  const char* name;
  RoleFinder fromTags, fromMarkers, fromNames;
};

// The words that tell a kit's Configuration or marker apart: its tags and its name, lower case.
std::string markerWords(const Tree& tree, InstanceId marker);

// Runs every finder, strongest evidence first: tags, markers, names. A part that has a
// role keeps it against weaker evidence.
void findRoles(RoleContext& context);

// The part that counts of a tagged model or folder: the one called Touch, Goal, Hitbox or the like,
// else its primary part, else the first. A part is its own. Null if none of it is in the level.
PartDraft* touchPart(RoleContext& context, InstanceId id);

// True if some evidence gave the part a role called `role`.
bool hasEvidence(const PartDraft& part, const char* role);

// The evidence of a part that does not hurt, by its tag or by a probe. Other roles are unaffected.
constexpr const char* kHarmless = "harmless";

// True if anything but its shape, its joints, what scripts set at the start and that it is harmless
// is known about the part.
bool hasRole(const PartDraft& part);

// The finders of each role file.
void harmlessFromTags(RoleContext&);
void killFromTags(RoleContext&);
void killFromMarkers(RoleContext&);
void killFromNames(RoleContext&);
void checkpointFromTags(RoleContext&);
void checkpointFromMarkers(RoleContext&);
void checkpointFromNames(RoleContext&);
// Parts numbered in one row with checkpoints, that scripts listen to or that are in a folder of
// stages: they ask for more than the touches that were tried.
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
