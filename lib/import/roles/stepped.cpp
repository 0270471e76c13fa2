// Follows the steps of a loop round by round.
#include "import/roles/stepped.h"

#include <algorithm>

#include "import/motion.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr double kStepInstant = 1e-4;   // seconds
constexpr size_t kMostFollowed = 5000;  // followed until a round goes as the one before
constexpr double kAlignSeconds = 0.5;   // an AlignPosition or BodyPosition without a speed limit

// How far it comes until the next goal is set; without a `speed`, there.
Pose reached(const Pose& from, const Pose& goal, double seconds, double speed) {
  const double way = double(length(goal.position - from.position));
  const double most = speed * std::max(seconds, 0.0);
  if (!(speed > 0) || !(way > most)) return goal;
  return between(from, goal, float(most / way));
}

}  // namespace

std::optional<Steps> stepsOf(const RoleContext& context, InstanceId id,
                             std::initializer_list<const char*> names) {
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines) {
      if (!timeline.byItself() || !timeline.forever || !(timeline.period > 0)) continue;
      Steps steps{{}, timeline.loopStart, timeline.period};
      for (size_t i = timeline.loopEvent; i < timeline.events.size(); ++i) {
        const ScriptEvent& e = timeline.events[i];
        for (const char* name : names)
          if (e.target == id && e.property == name) steps.events.push_back(&e);
      }
      if (steps.events.empty()) continue;
      // One round, which begins with the first: of a loop that was followed for longer.
      steps.start = steps.events.front()->time;
      std::erase_if(steps.events, [&](const ScriptEvent* e) {
        return e->time - steps.start > steps.period - kStepInstant;
      });
      if (!steps.events.empty()) return steps;
    }
  return std::nullopt;
}

Motion stepped(const Pose& start, const Goals& goals, const Steps& steps, double speed) {
  Motion motion;
  beginAt(motion, steps.start);
  const auto until = [&](size_t i) {
    return i + 1 < goals.size() ? goals[i + 1].first : steps.period;
  };
  Pose last = start;
  const size_t rounds = std::clamp<size_t>(kMostFollowed / goals.size(), 24, kMostFollowed);
  for (size_t round = 0; round < rounds; ++round) {
    const Vec3 before = last.position;
    for (size_t i = 0; i < goals.size(); ++i)
      last = reached(last, goals[i].second, until(i) - goals[i].first, speed);
    if (last.position == before) break;  // so do all that follow
  }
  const auto add = [&](double time, const Pose& pose) {
    const double at = motion.keys.empty() ? 0 : std::max(time, double(motion.keys.back().time));
    motion.keys.push_back({float(at), pose, Easing::linear, EasingDirection::out});
  };
  add(0, last);
  for (size_t i = 0; i < goals.size(); ++i) {
    const double way = double(length(goals[i].second.position - last.position));
    const double takes = speed > 0 ? way / speed : kAlignSeconds;
    add(goals[i].first, last);
    last = reached(last, goals[i].second, until(i) - goals[i].first, speed);
    add(std::min(goals[i].first + takes, until(i)), last);
  }
  add(steps.period, last);
  return motion;
}

}  // namespace obby::importer
