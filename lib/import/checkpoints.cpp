#include "import/checkpoints.h"

#include "import/pose_math.h"
#include "import/stages/course.h"
#include "import/stages/numbers.h"

namespace obby::importer {
namespace {

// A pad that sets a SpawnLocation elsewhere stands for it: what numbers that one numbers the pad.
void joinRespawns(const Tree& tree, LevelDraft& level) {
  for (PartDraft& pad : level.parts) {
    const InstanceId respawn = pad.stageSigns.respawn;
    if (!pad.checkpoint || respawn == pad.id || respawn >= tree.size()) continue;
    PartDraft target;
    target.id = respawn;
    readNumbers(tree, respawn, target);
    for (size_t i = 0; i < kNumberSources; ++i)
      if (pad.stageSigns.numbers[i] == kUnnumbered)
        pad.stageSigns.numbers[i] = target.stageSigns.numbers[i];
  }
}

// A team's number counts for the pads that set the team.
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
