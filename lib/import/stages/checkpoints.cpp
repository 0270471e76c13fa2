#include "import/stages/checkpoints.h"

#include <map>

#include "import/document/pose_math.h"
#include "import/stages/course.h"
#include "import/stages/numbers.h"

namespace obby::importer {
namespace {

void takeMissing(StageSigns& to, const StageSigns& from) {
  for (size_t i = 0; i < kNumberSources; ++i)
    if (to.numbers[i] == kUnnumbered) to.numbers[i] = from.numbers[i];
}

// Joins a pad with the SpawnLocation that it sets, if that is another part. The pad takes over the
// numbers that it lacks. If the SpawnLocation is a checkpoint next to the pad, it represents both.
void joinRespawns(const Tree& tree, LevelDraft& level) {
  std::map<InstanceId, PartDraft*> spawns;
  for (PartDraft& part : level.parts)
    if (tree.at(part.id).className == "SpawnLocation") spawns[part.id] = &part;
  for (PartDraft& pad : level.parts) {
    const auto found = spawns.find(pad.stageSigns.respawn);
    if (!pad.checkpoint || found == spawns.end() || found->second == &pad) continue;
    PartDraft& spawn = *found->second;
    const bool isNext = length(spawn.pose.position - pad.pose.position) < kOnePlatform;
    readNumbers(tree, spawn.id, spawn);
    if (spawn.checkpoint && isNext) {
      takeMissing(spawn.stageSigns, pad.stageSigns);
      pad.checkpoint.reset();
      std::erase_if(pad.evidence, [](const Evidence& e) { return e.role == "checkpoint"; });
    } else {
      takeMissing(pad.stageSigns, spawn.stageSigns);
    }
  }
}

// Gives a team's number to the pads that set the team.
void joinTeams(const Tree& tree, LevelDraft& level) {
  const auto numbers = numbersOfTeams(tree);
  for (PartDraft& pad : level.parts) {
    const auto team = pad.stageSigns.team ? numbers.find(*pad.stageSigns.team) : numbers.end();
    if (team != numbers.end()) pad.stageSigns[NumberFrom::team] = team->second;
  }
}

}  // namespace

SpawnDraft spawnOn(const Tree& tree, const PartDraft& part, int index, int stage) {
  SpawnDraft spawn;
  spawn.name = tree.at(part.id).name;
  spawn.stage = stage;
  const Vec3 half = boundsOf(part.pose, part.size * 0.5f).hi - part.pose.position;
  spawn.position = part.pose.position + Vec3{0, half.y, 0};
  spawn.yaw = yawOf(-part.pose.rotation.z);
  spawn.part = index;
  return spawn;
}

void orderStages(const Tree& tree, LevelDraft& level, const std::optional<Vec3>& arrived) {
  joinRespawns(tree, level);
  joinTeams(tree, level);
  Course course = courseOf(tree, level);
  findStart(course, arrived);
  orderCheckpoints(course);
  settleGoal(course);
  for (PartDraft& part : level.parts) part.checkpoint.reset();
  if (course.start >= 0) {
    level.spawns.push_back(spawnOn(tree, course.part(course.start), course.start, 0));
    if (course.arrived) level.spawns.back().position = *course.arrived;
  }
  int stage = 0;
  for (const int index : course.checkpoints) {
    course.part(index).checkpoint = ++stage;
    level.spawns.push_back(spawnOn(tree, course.part(index), index, stage));
  }
}

}  // namespace obby::importer
