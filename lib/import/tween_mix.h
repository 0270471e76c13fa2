// Tweens of one part that do not simply come one after the other. As in the engine, one that is
// played while another drives the same property ends that one where it has come to; tweens of
// different properties go on side by side; a pose that is set counts for what no tween drives.
#pragma once

#include <optional>
#include <vector>

#include "import/script_reading.h"

namespace obby::importer {

// Tweens of a part and poses that are set, all with their frames, in the order of time.
using PoseEvents = std::vector<const ScriptEvent*>;

// Whether appendTween of one after the other would give another way: poses are set, a tween begins
// before one before it has ended, or a script stops one or lets it go on. `period`: seconds of a
// round, 0 for what comes but once.
bool isMixed(const PoseEvents& events, double period);

struct Mixed {
  std::optional<Motion> motion;
  bool tooLong = false;  // without a motion: that would have too many keys or changes
};

// The motion of mixed events, which are not empty, from `start` on; with a `period` that of the
// round that begins at `zero`. None where they make no single motion: a tween of the CFrame beside
// one of the Position or the Orientation, endless ones that have no common round, one that is
// endless beside others that come but once; nor where it is too long.
Mixed mixedMotion(const Pose& start, const PoseEvents& events, double zero, double period);

}  // namespace obby::importer
