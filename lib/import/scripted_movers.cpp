// Collects the targets of poses that are set more than once, or over some time.
#include "import/scripted_movers.h"

#include "import/onset.h"
#include "import/pose_steps.h"

namespace obby::importer {
namespace {

// A pose that the text does not tell makes a mover, too: it is named as one that is not followed.
bool moves(const Tree& tree, const Timeline& timeline, size_t index) {
  const ScriptEvent& event = timeline.events[index];
  return event.property == "CFrame" && changesParts(tree, event) &&
         (event.kind == EventKind::tween || isLooped(timeline, index) || !event.frame);
}

}  // namespace

ScriptedMovers::ScriptedMovers(const RoleContext& context) : tree_(context.tree) {
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines) {
      if (!timeline.byItself()) continue;
      for (size_t i = 0; i < timeline.events.size(); ++i)
        if (moves(tree_, timeline, i)) targets_[timeline.events[i].target].insert(reading.script);
      for (const auto& [target, steps] : poseSteps(tree_, reading, timeline))
        targets_[target].insert(reading.script);
    }
}

const std::set<InstanceId>& ScriptedMovers::of(InstanceId part) {
  const auto [known, isNew] = known_.try_emplace(part);
  if (!isNew) return known->second;
  for (InstanceId up = part; up != kNoInstance; up = tree_.at(up).parent) {
    const auto target = targets_.find(up);
    if (target == targets_.end() || (up != part && tree_.isPart(up))) continue;
    known->second.insert(target->second.begin(), target->second.end());
  }
  return known->second;
}

}  // namespace obby::importer
