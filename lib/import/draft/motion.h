// Builds motions from sampled poses and gives them to the parts that move.
#pragma once

#include <string>
#include <vector>

#include "import/draft/role_context.h"

namespace obby::importer {

struct PoseSample {
  double time = 0;  // seconds
  Pose pose;
};

// Returns keys through the samples of a loop of `period` seconds, without poses that lie on a
// straight line. Steps rarer than every 0.15 s are jumps; others are smooth. A `closed` loop leads
// back to `start` at `period`.
std::vector<MotionKey> keysFrom(const Pose& start, const std::vector<PoseSample>& samples,
                                double period, bool closed);

// Returns keys straight through the samples, without poses that lie on a straight line.
std::vector<MotionKey> keysThrough(const Pose& start, const std::vector<PoseSample>& samples);

// Returns the motion with extra keys on its turns. The simulator interpolates linearly between
// keys, but a part `reach` studs from the pivot moves on an arc.
Motion withArcs(const Motion& motion, float reach);

// Gives `motion` to every part that moves with `moved`, a part or model whose pivot has the poses.
// Those are the parts below a model, and unanchored parts welded to it. Parts that have a motion
// keep it. `reason` becomes evidence. Returns the number of parts that got the motion. Returns 0,
// with a note, if the parts that a player can meet would exceed the level's keys or ticks. Other
// parts move while the budget lasts.
int giveMotion(RoleContext& context, InstanceId moved, const Motion& motion,
               const std::string& reason, bool guessed);

bool samePose(const Pose& a, const Pose& b);

}  // namespace obby::importer
