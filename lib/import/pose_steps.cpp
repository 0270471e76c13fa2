// Poses that are set at once are where the way begins; what comes later are its steps.
#include "import/pose_steps.h"

#include <set>
#include <vector>

#include "import/motion.h"
#include "import/onset.h"
#include "import/pivot.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

constexpr size_t kLeastSteps = 3;  // fewer are changes, which are named

bool isStep(const Timeline& timeline, size_t index) {
  const ScriptEvent& event = timeline.events[index];
  return event.kind == EventKind::set && event.frame && !event.unsure &&
         event.time <= double(kLongestMotion) && index < timeline.awaits &&
         !isLooped(timeline, index);
}

// Whether the poses after the start go on from one to the next often enough.
bool moves(const Pose& rest, const PoseEvents& events) {
  Pose now = rest, last = rest;
  size_t steps = 0;
  for (const ScriptEvent* event : events) {
    now = goalOf(now, *event);
    if (event->time < kAtOnce) last = now;
    if (event->time < kAtOnce || samePose(now, last)) continue;
    last = now;
    ++steps;
  }
  return steps >= kLeastSteps;
}

}  // namespace

std::map<InstanceId, PoseEvents> poseSteps(const Tree& tree, const ScriptReading& reading,
                                           const Timeline& timeline) {
  std::map<InstanceId, PoseEvents> all;
  if (timeline.trigger != Trigger::start || timeline.vague || reading.exhausted) return all;
  std::set<InstanceId> others;  // that something else moves, too
  for (size_t i = 0; i < timeline.events.size(); ++i) {
    const ScriptEvent& event = timeline.events[i];
    if (event.property != "CFrame" || event.target == kNoInstance) continue;
    PoseEvents& steps = all[event.target];
    const bool backInTime = !steps.empty() && event.time < steps.back()->time;
    if (isStep(timeline, i) && !backInTime)
      steps.push_back(&event);
    else
      others.insert(event.target);
  }
  std::erase_if(all, [&](const auto& found) {
    const auto& [id, steps] = found;
    return others.count(id) > 0 || steps.size() < kLeastSteps || !moves(pivotOf(tree, id), steps);
  });
  return all;
}

Motion motionThrough(const Pose& start, const PoseEvents& steps) {
  Pose now = start, first = start;
  std::vector<PoseSample> samples;
  for (const ScriptEvent* event : steps) {
    now = goalOf(now, *event);
    if (event->time < kAtOnce)
      first = now;
    else
      samples.push_back({event->time, now});
  }
  Motion motion;
  motion.repeat = Repeat::once;
  motion.keys = keysFrom(first, samples, 0, false);
  return motion;
}

}  // namespace obby::importer
