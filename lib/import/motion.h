// Building motions from sampled poses, tweens and way points, and giving them to the parts that
// move.
#pragma once

#include <string>
#include <vector>

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

// Keys through the samples of a loop of `period` seconds; poses on a straight way are left out.
// Steps rarer than every 0.15 s are jumps, others a smooth way. `closed`: it leads
// back to `start` at `period`.
std::vector<MotionKey> keysFrom(const Pose& start, const std::vector<PoseSample>& samples,
                                double period, bool closed);

// Keys of all motions of a level together: 56 MB, and as much in its record. Their rounds together
// may have as many ticks as a level takes (kMaxLevelRows).
constexpr size_t kMaxLevelKeys = 1000000;

// Gives `motion`, whose poses are those of the pivot of `moved` (a part or model), to every part
// that moves with it: parts below a model, parts welded to it that are not anchored themselves.
// Parts that have a motion keep it. `reason` becomes evidence. Returns the number of parts that got
// the motion: none, with a note, where the level would have more keys or ticks than it may.
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
