// Builds the level: world, parts, strays, roles, stages, losses and the ground.
#include "import/level/build_level.h"

#include <algorithm>

#include <optional>

#include "import/document/assemblies.h"
#include "import/document/classes.h"
#include "import/draft/motion_budget.h"
#include "import/draft/world.h"
#include "import/level/chance.h"
#include "import/level/culling.h"
#include "import/level/doubts.h"
#include "import/level/dynamic.h"
#include "import/level/unmodelled.h"
#include "import/observed/roles.h"
#include "import/parts/collision_groups.h"
#include "import/parts/parts.h"
#include "import/parts/scene.h"
#include "import/parts/terrain.h"
#include "import/roles/role.h"
#include "import/roles/script_hints.h"
#include "import/stages/checkpoints.h"

namespace obby::importer {
namespace {

std::string worldPath(const Tree& tree) {
  const auto roots = tree.worldRoots();
  return roots.size() == 1 ? tree.path(roots[0]) : "";
}

void readParts(const Tree& tree, const Assemblies& assemblies, const CollisionGroups& groups,
               LevelDraft& level) {
  LevelHulls hulls;
  for (InstanceId id : sceneParts(tree, level)) {
    ++level.partsRead;
    auto part = partFrom(tree, id, hulls, level);
    if (!part) continue;
    if (!part->anchored && assemblies.anchored(id)) {
      part->anchored = true;
      part->evidence.push_back({"anchored", "joined to an anchored part", false});
    }
    groups.apply(*part);
    if (!groups.isSettled(tree.at(id)))
      level.noteUnmodelled(
          "collision group " + groupNameOf(tree.at(id)), tree, id,
          "its collisions are unknown: the file does not list the group, or scripts change groups");
    level.parts.push_back(std::move(*part));
  }
}

// Returns the feet of a new player at the time of the first probes.
std::optional<Vec3> arrivedAt(const ObservedPlace& place) {
  if (!place.ran || !place.report.arrived.alive) return std::nullopt;
  return place.report.arrived.feet;
}

// Returns true if scripts ran and failed only by errors that the real engine raises, too.
bool scriptsTell(const Tree& tree, const ObservedPlace& place) {
  const auto& problems = place.report.undisturbed.problems;
  bool any = false;
  for (InstanceId id = 0; id < tree.size() && !any; ++id)
    any = isScriptClass(tree.at(id).className) && tree.at(id).className != "ModuleScript";
  return any && place.ran && place.report.failure.empty() &&
         std::all_of(problems.begin(), problems.end(), [](const engine::Problem& problem) {
           return problem.failure == engine::Failure::refused;
         });
}

void findRolesOf(RoleContext& context, const ObservedPlace& place) {
  noteSettled(context, place);
  applyPlayerState(context, place);
  movingFromRecordings(context);  // the designer's own samples take precedence
  movingFromObservation(context, place.report);
  timersFromObservation(context, place.report);
  broughtFromObservation(context, place);
  // A tagged checkpoint may also kill, to bring the player to the next stage.
  checkpointFromTags(context);
  goalFromTags(context);
  killFromTags(context);
  touchesFromObservation(context, place.report);
  findRoles(context);
  touchedDrivesFromObservation(context, place.report);
  laterTouchesFromObservation(context, place.report);
  checkpointFromSiblings(context);
  hintsFromScripts(context, place);
  movesFromObservation(context, place.report);
  noteObservedLosses(context, place);
  noteUnraised(context, place.report);
}

}  // namespace

LevelDraft buildLevel(const Tree& tree, const ObservedPlace& place, const std::string& name) {
  LevelDraft level;
  level.file = tree.document().file;
  level.format = tree.document().format;
  level.name = name;
  level.path = worldPath(tree);
  readWorld(tree, level);
  const Assemblies assemblies(tree);
  const bool tells = scriptsTell(tree, place);
  readParts(tree, assemblies, CollisionGroups(tree, place, tells, level), level);
  cullStrays(level, tree);
  RoleContext context(tree, assemblies, level);
  context.scriptsTell = tells;
  findRolesOf(context, place);
  settleMotions(context);
  dynamicParts(tree, assemblies, level);
  orderStages(tree, level, arrivedAt(place));
  noteUnmodelled(context);
  addTerrain(tree, level);
  for (const ObservedPlace& other : place.others)
    noteChance(level, tree, place.fromFile, buildLevel(Tree(other.document), other, name));
  markDoubts(context);
  return level;
}

}  // namespace obby::importer
