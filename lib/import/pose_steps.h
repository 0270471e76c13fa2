// Parts and models that a script moves but once, step by step, as
// `for i = 1, 40 do part.CFrame = part.CFrame * CFrame.new(0, 0.1, 0) task.wait(0.05) end` does.
#pragma once

#include <map>

#include "import/tween_mix.h"

namespace obby::importer {

// By part or model, the poses that a timeline sets of it, in their order, the first as play starts
// or later. Only where the text tells all of them and when they come, where three or more are
// steps, and where nothing else in the timeline moves it: no tween, no endless loop.
std::map<InstanceId, PoseEvents> poseSteps(const Tree& tree, const ScriptReading& reading,
                                           const Timeline& timeline);

// The way through them, from `start`, where the part or model is as play starts.
Motion motionThrough(const Pose& start, const PoseEvents& steps);

}  // namespace obby::importer
