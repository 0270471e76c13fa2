// The motion of a tween, as TweenService makes it: each goal property goes its eased way by itself,
// so that an Orientation turns by as many degrees as its goal says.
#pragma once

#include <vector>

#include "import/script_reading.h"

namespace obby::importer {

// Appends all rounds of a tween of poses, played `time` seconds after the first key, to `keys`,
// which are not empty; the pose before it is held until it begins. `event` has its frame.
void appendTween(std::vector<MotionKey>& keys, const ScriptEvent& event, double time);

// The turn of an endless tween that starts over at each whole turn, in the frame of `start`;
// nothing if it is anything else.
std::optional<Spin> spinOfTween(const Pose& start, const ScriptEvent& event);

}  // namespace obby::importer
