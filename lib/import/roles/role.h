// Roles are the effects of parts on a player. Each role is one file in this folder and one row in
// role_table.cpp. A row names the role's finder for each kind of evidence.
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

// The data that the role finders read and write.
class RoleContext {
 public:
  RoleContext(const Tree& tree, const Assemblies& assemblies, LevelDraft& level);

  const Tree& tree;
  const Assemblies& assemblies;
  LevelDraft& level;
  // Every script of the place ran without an error. Parts that none of them makes deadly are
  // harmless.
  bool scriptsTell = false;
  // Budget spent by parts that a player can meet, and by parts that had no role yet.
  MotionRoom metRoom, unmetRoom;
  std::vector<InstanceId> unmetMoving;  // unmet parts that move
  // Unmet parts beyond the budget, with the reason why they would move.
  std::map<InstanceId, std::string> unmetStill;

  // Returns the draft of a part instance, or null if it is not in the level.
  PartDraft* part(InstanceId id);
  // Returns the drafts of the part itself, or of every level part below a model or folder.
  std::vector<PartDraft*> partsOf(InstanceId id);
  // Returns true if partsOf returns any, at less cost.
  bool hasParts(InstanceId id);
  // Calls `visit` once for every instance with one of the tags (any case). It passes the first tag
  // that the instance has, as the file writes it.
  void eachTagged(const std::vector<std::string_view>& tags,
                  const std::function<void(InstanceId, const std::string& tag)>& visit) const;
  // Calls `visit` with every marker child that a tower kit may hang below a part or model (value
  // objects and Configurations), and with the instance that it marks.
  void eachMarker(const std::function<void(InstanceId marker, InstanceId owner)>& visit) const;

 private:
  std::unordered_map<InstanceId, size_t> index_;
  std::unordered_map<InstanceId, bool> holders_;  // cache of hasParts, which scripts call often
};

using RoleFinder = void (*)(RoleContext&);

// One role with a finder for each kind of evidence, or null for none.
struct RoleRow {
  const char* name;
  RoleFinder fromTags, fromMarkers, fromNames;
};

// Returns the words that identify a kit's Configuration or marker: its tags and its name, lower
// case.
std::string markerWords(const Tree& tree, InstanceId marker);

// Runs every finder, strongest evidence first: tags, markers, names. A part that has a
// role keeps it against weaker evidence.
void findRoles(RoleContext& context);

// Returns the part that represents a tagged model or folder: the one called Touch, Goal, Hitbox or
// the like, else its primary part, else the first. A part represents itself. Returns null if none
// of it is in the level.
PartDraft* touchPart(RoleContext& context, InstanceId id);

// Returns true if some evidence gave the part a role called `role`.
bool hasEvidence(const PartDraft& part, const char* role);

// The evidence that a part does not hurt, by its tag or by a probe. Other roles are unaffected.
constexpr const char* kHarmless = "harmless";

// Returns true if the part has evidence of anything but its shape, its joints, script changes at
// the start, and harmlessness.
bool hasRole(const PartDraft& part);

// The finders of each role file.
void harmlessFromTags(RoleContext&);
void killFromTags(RoleContext&);
void killFromMarkers(RoleContext&);
void killFromNames(RoleContext&);
void checkpointFromTags(RoleContext&);
void checkpointFromMarkers(RoleContext&);
void checkpointFromNames(RoleContext&);
// Finds parts in one numbered row with checkpoints, with listeners or in a folder of stages. They
// need more than the touches that were tried.
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
