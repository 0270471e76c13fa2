// Parts that a script moves but once, step by step.
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "import/onset.h"
#include "import/pivot.h"
#include "import/pose_steps.h"
#include "import/roles/script_motions.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

// What the threads of a script set of poses, but for what comes round again, by part or model.
struct Places {
  std::map<InstanceId, PoseEvents> atStart;
  std::map<InstanceId, const Timeline*> later;  // the first thread that does so after the start
  std::set<InstanceId> shared;                  // of which another one does, too
};

// Adds a pose. Those before it of which it sets all again count no more: a few are left.
void take(PoseEvents& poses, const ScriptEvent& last) {
  std::erase_if(poses, [&](const ScriptEvent* pose) {
    return (last.places || !pose->places) && (last.turns || !pose->turns);
  });
  poses.push_back(&last);
}

Places placesOf(const ScriptReading& reading) {
  Places places;
  for (const Timeline& timeline : reading.timelines) {
    if (timeline.trigger != Trigger::start) continue;
    for (size_t i = 0; i < timeline.events.size(); ++i) {
      const ScriptEvent& event = timeline.events[i];
      const bool pose = event.kind == EventKind::set && event.property == "CFrame";
      if (!pose || isLooped(timeline, i)) continue;
      if (event.time < kAtOnce) {
        if (event.frame && !event.unsure) take(places.atStart[event.target], event);
      } else if (places.later.try_emplace(event.target, &timeline).first->second != &timeline) {
        places.shared.insert(event.target);
      }
    }
  }
  return places;
}

}  // namespace

void addSteps(RoleContext& context, ScriptMotions& motions) {
  for (const ScriptReading& reading : context.scripts) {
    Places places = placesOf(reading);
    for (const Timeline& timeline : reading.timelines)
      for (const auto& [id, steps] : poseSteps(context.tree, reading, timeline)) {
        const Pose rest = pivotOf(context.tree, id);
        Pose start = rest;
        for (const ScriptEvent* event : places.atStart[id]) start = goalOf(start, *event);
        ScriptMotion found;
        found.id = id;
        found.rest = rest.rotation;
        found.motion = motionThrough(start, steps);
        found.reason = scriptReason(context.tree, reading, steps.front()->line);
        found.places = found.turns = false;
        takeEvents(found, steps);
        if (places.shared.count(id) > 0)
          motions.leave(
              id, "part that two scripts move",
              "another thread of the script also places it, which is ignored; " + found.reason);
        motions.add(std::move(found));
      }
  }
}

}  // namespace obby::importer
