// Building motions from sampled poses, tweens and way points, and giving them to the parts that
// move.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/motion_room.h"
#include "import/roles/role.h"

namespace obby::importer {

struct PoseSample {
  double time = 0;  // seconds
  Pose pose;
};

// A constant turn about a fixed point: `samples` follow `start`, the last at or before `period`
// seconds, evenly spaced. Axis and pivot are in the frame of `start`. Nothing if it is anything
// else.
std::optional<Spin> spinFrom(const Pose& start, const std::vector<PoseSample>& samples,
                             double period);

// Seconds after which the samples of an open loop nearly repeat: those of a sine of the clock,
// whose period is no whole number of frames. Nothing if they never come within 1 % of their range.
std::optional<double> nearPeriod(const std::vector<PoseSample>& samples);

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

// Marker parts that only show a mover where to go are no obstacles: they lose their collision if
// they have no role and are invisible or as large as the mover.
void hideMarker(RoleContext& context, InstanceId marker, InstanceId mover);

// Puts off a motion that repeats by the seconds that its script waits before it. The simulator's
// clock has no beginning for it: until then it moves as if it had gone on for ever.
void beginAt(Motion& motion, double seconds);

bool samePose(const Pose& a, const Pose& b);

}  // namespace obby::importer
