// Building motions from sampled poses, and giving them to the parts that move.
#pragma once

#include <string>
#include <vector>

#include "import/motion_room.h"
#include "import/roles/role.h"

namespace obby::importer {

struct PoseSample {
  double time = 0;  // seconds
  Pose pose;
};

// Keys through the samples of a loop of `period` seconds; poses on a straight way are left out.
// Steps rarer than every 0.15 s are jumps, others a smooth way. `closed`: it leads
// back to `start` at `period`.
std::vector<MotionKey> keysFrom(const Pose& start, const std::vector<PoseSample>& samples,
                                double period, bool closed);

// Keys straight through the samples; poses on a straight way are left out.
std::vector<MotionKey> keysThrough(const Pose& start, const std::vector<PoseSample>& samples);

// The motion with keys on its turns: the simulator goes straight from key to key, and a part that
// hangs `reach` studs off what turns does not.
Motion withArcs(const Motion& motion, float reach);

// Gives `motion`, whose poses are those of the pivot of `moved` (a part or model), to every part
// that moves with it: parts below a model, parts welded to it that are not anchored themselves.
// Parts that have a motion keep it. `reason` becomes evidence. Returns the number of parts that got
// the motion: none, with a note, where those that a player can meet would need more keys or ticks
// than a level may have. Others get it while there is room for them, too.
int giveMotion(RoleContext& context, InstanceId moved, const Motion& motion,
               const std::string& reason, bool guessed);

bool samePose(const Pose& a, const Pose& b);

}  // namespace obby::importer
