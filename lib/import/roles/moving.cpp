// Moving and spinning parts whose scripts set poses in a loop or play tweens.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "import/motion.h"
#include "import/pivot.h"
#include "import/pose_math.h"
#include "import/roles/script_motions.h"
#include "import/tween_mix.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

constexpr double kInstant = 1e-4;  // seconds

struct Moved {
  Pose rest;   // in the file
  Pose start;  // when the loop or the first tween begins
  PoseEvents sets, tweens;
  PoseEvents early;                      // tweens before the loop
  Pose earlyStart;                       // when the first of them begins
  const ScriptEvent* endless = nullptr;  // of the early ones, that nothing after it ends
  Pose endlessStart;
  bool loops = false;    // in the loop of the timeline; else it moves but once, or by its tween
  bool unknown = false;  // a pose that the text does not tell
};

bool isPose(const ScriptEvent& e) {
  return e.property == "CFrame" && (e.kind == EventKind::set || e.kind == EventKind::tween);
}

void takeEarly(Moved& moved, const ScriptEvent& event) {
  if (event.kind == EventKind::tween) {
    if (moved.early.empty()) moved.earlyStart = moved.start;
    moved.early.push_back(&event);
    if (event.tween.repeats < 0 && !std::isfinite(event.until)) {
      moved.endless = &event;
      moved.endlessStart = moved.start;
    }
  }
  moved.start = poseAfter(moved.start, event);
}

// What the loop does not move goes on as it was begun before it.
void settleLoop(Moved& moved, bool forever) {
  moved.loops = forever && !(moved.sets.empty() && moved.tweens.empty());
  if (moved.loops || moved.early.empty()) return;
  moved.tweens.swap(moved.early);
  moved.start = moved.earlyStart;
  moved.endless = nullptr;
}

std::map<InstanceId, Moved> movedBy(const Tree& tree, const Timeline& timeline) {
  std::map<InstanceId, Moved> all;
  const size_t loop = timeline.forever ? timeline.loopEvent : 0;
  for (size_t i = 0; i < timeline.events.size(); ++i) {
    const ScriptEvent& event = timeline.events[i];
    if (!isPose(event) || event.target == kNoInstance) continue;
    const auto [it, isNew] = all.try_emplace(event.target);
    Moved& moved = it->second;
    if (isNew) moved.rest = moved.start = pivotOf(tree, event.target);
    if (moved.endless && setTheSame(*moved.endless, event)) moved.endless = nullptr;
    if (!event.frame) {
      moved.unknown = true;
    } else if (i < loop) {
      takeEarly(moved, event);
    } else if (event.kind == EventKind::set) {
      if (!timeline.forever && moved.tweens.empty()) moved.start = goalOf(moved.start, event);
      moved.sets.push_back(&event);
    } else {
      moved.tweens.push_back(&event);
    }
  }
  for (auto& [id, moved] : all) settleLoop(moved, timeline.forever);
  return all;
}

Motion spinning(const Spin& spin, const Pose& start, const Pose& rest, double begin) {
  Motion motion;
  motion.spin = spin;
  beginAt(motion, begin);
  if (!samePose(start, rest)) motion.keys = {{0, start, Easing::linear, EasingDirection::out}};
  return motion;
}

std::optional<Motion> endlessTween(const Moved& moved) {
  Pose start = moved.start;
  for (const ScriptEvent* event : moved.tweens) {
    if (event->tween.repeats >= 0) {
      start = poseAfter(start, *event);
      continue;
    }
    if (const auto spin = spinOfTween(start, *event))
      return spinning(*spin, start, moved.rest, event->time);
    return endlessMotion(start, *event);
  }
  return std::nullopt;
}

// All that one round of the loop, or what comes but once, does to the part. What is set before the
// first tween is where that begins.
PoseEvents playedBy(const Timeline& timeline, const Moved& moved) {
  PoseEvents all = moved.tweens;
  for (const ScriptEvent* set : moved.sets)
    if (moved.loops || set > moved.tweens.front()) all.push_back(set);
  // In the order of the text first: of what comes at one time the last counts.
  std::sort(all.begin(), all.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const auto* a, const auto* b) { return a->time < b->time; });
  if (moved.loops && timeline.period > 0) {
    const double end = all.front()->time + timeline.period - kInstant;
    std::erase_if(all, [&](const ScriptEvent* event) { return event->time > end; });
  }
  return all;
}

// Where the keys of a loop begin: with its first tween if the last one goes on into the next round,
// as in `while true do wait(2) there:Play() wait(2) back:Play() end`.
double beginOfRound(const Timeline& timeline, const PoseEvents& events) {
  const double end = timeline.loopStart + timeline.period + kInstant;
  const bool goesOn = std::any_of(events.begin(), events.end(), [&](const ScriptEvent* event) {
    return event->kind == EventKind::tween && endOf(*event) > end;
  });
  return goesOn ? events.front()->time : timeline.loopStart;
}

// Why tweens that do not simply come one after the other give the part no motion.
enum class Clash { none, noSingle, tooLong };

std::optional<Motion> tweenMotion(const Timeline& timeline, const Moved& moved, Clash& clash) {
  if (moved.tweens.empty()) return std::nullopt;
  const PoseEvents events = playedBy(timeline, moved);
  const bool endless = std::any_of(moved.tweens.begin(), moved.tweens.end(),
                                   [](const auto* event) { return event->tween.repeats < 0; });
  const bool alone = endless && moved.loops && events.size() == 1 &&
                     !std::isfinite(events.front()->until);  // one goes on in all rounds
  const double period = moved.loops ? timeline.period : 0;
  const double zero = moved.loops ? beginOfRound(timeline, events) : 0;
  if (!alone && !events.empty() && isMixed(events, period)) {
    Mixed mixed = endless && moved.loops ? Mixed{} : mixedMotion(moved.start, events, zero, period);
    if (!mixed.motion) clash = mixed.tooLong ? Clash::tooLong : Clash::noSingle;
    return std::move(mixed.motion);
  }
  if (auto motion = endlessTween(moved)) return motion;
  Motion motion;
  motion.repeat = moved.loops ? Repeat::loop : Repeat::once;
  beginAt(motion, zero);  // what comes but once waits with its keys
  // In a loop the first round starts where the last one ends.
  Pose start = moved.start;
  const PoseEvents& played = events.empty() ? moved.tweens : events;
  for (const ScriptEvent* event : played)
    if (moved.loops) start = poseAfter(start, *event);
  motion.keys = {{0, start, Easing::linear, EasingDirection::out}};
  for (const ScriptEvent* event : played) appendTween(motion.keys, *event, event->time - zero);
  if (moved.loops && timeline.period > double(motion.keys.back().time))
    motion.keys.push_back(
        {float(timeline.period), motion.keys.back().pose, Easing::linear, EasingDirection::out});
  return motion;
}

struct LoopMotion {
  Motion motion;
  bool open = false;  // never repeats while it was followed
  double period = 0;
};

std::optional<LoopMotion> loopMotion(const Timeline& timeline, const Moved& moved) {
  if (moved.sets.empty() || !timeline.forever || !(timeline.period > 0)) return std::nullopt;
  std::vector<PoseSample> samples;
  Pose now = moved.start;
  for (const ScriptEvent* event : moved.sets) {
    now = goalOf(now, *event);
    samples.push_back({event->time - timeline.loopStart, now});
  }
  LoopMotion loop;
  loop.period = timeline.period;
  const bool still = std::all_of(samples.begin(), samples.end(), [&](const PoseSample& s) {
    return samePose(s.pose, moved.start);
  });
  if (still) return std::nullopt;
  const auto cut = [&](double period) {
    std::erase_if(samples, [&](const PoseSample& s) { return s.time > period - kInstant; });
    loop.period = period;
  };
  if (timeline.closed) cut(timeline.period);
  if (auto spin = spinFrom(moved.start, samples, loop.period)) {
    loop.motion = spinning(*spin, moved.start, moved.rest, timeline.loopStart);
    return loop;
  }
  const auto near = timeline.closed ? std::nullopt : nearPeriod(samples);
  if (near) cut(*near);
  loop.open = !timeline.closed && !near;
  loop.motion.keys = keysFrom(moved.start, samples, loop.period, !loop.open);
  beginAt(loop.motion, timeline.loopStart);
  return loop;
}

// The endless tween from before the loop moves the part that the loop turns, or the other way
// round.
bool goesOnBeside(Motion& motion, const Moved& moved) {
  if (motion.spin && motion.keys.size() <= 1 && !moved.endless->turns) {
    const Mat3 start =
        motion.keys.empty() ? moved.rest.rotation : motion.keys.front().pose.rotation;
    Motion both = endlessMotion(moved.endlessStart, *moved.endless);
    addSpin(both, *motion.spin, start, -double(motion.offset));
    motion = std::move(both);
    return true;
  }
  const auto spin = spinOfTween(moved.endlessStart, *moved.endless);
  if (!spin || motion.spin) return false;
  addSpin(motion, *spin, moved.endlessStart.rotation, moved.endless->time);
  return true;
}

// What the events of one timeline set of a pose, and after which parts.
ScriptMotion described(const Moved& moved) {
  ScriptMotion found;
  found.rest = moved.rest.rotation;
  found.places = moved.endless && moved.endless->places;
  found.turns = moved.endless && moved.endless->turns;
  takeEvents(found, moved.sets);
  takeEvents(found, moved.tweens);
  return found;
}

void takeMoved(ScriptMotions& motions, const Timeline& timeline, InstanceId id, const Moved& moved,
               std::string reason) {
  bool open = false;
  Clash clash = Clash::none;
  auto motion = tweenMotion(timeline, moved, clash);
  if (!motion && clash == Clash::none) {
    auto loop = loopMotion(timeline, moved);
    if (!loop) return;
    motion = std::move(loop->motion);
    open = loop->open;
    if (open)
      reason += " (starts over after " + std::to_string(int(std::min(loop->period, 1e6))) + " s)";
  }
  if (clash == Clash::none && moved.endless && !goesOnBeside(*motion, moved))
    clash = Clash::noSingle;
  if (clash != Clash::none) return motions.leaveMixed(id, clash == Clash::tooLong, reason);
  const bool cut = std::any_of(moved.tweens.begin(), moved.tweens.end(), [](const auto* event) {
    return event->tween.repeats > kMostTweenRepeats;
  });
  if (cut)
    motions.leave(id, "tween with many repeats",
                  "ends after " + std::to_string(kMostTweenRepeats + 1) + " rounds; " + reason);
  ScriptMotion found = described(moved);
  found.id = id;
  found.motion = std::move(*motion);
  found.reason = std::move(reason);
  found.guessed = found.guessed || open || timeline.vague;
  motions.add(std::move(found));
}

void takeAll(const Tree& tree, ScriptMotions& motions, const ScriptReading& reading,
             const Timeline& timeline) {
  for (const auto& [id, moved] : movedBy(tree, timeline)) {
    const auto& events = moved.tweens.empty() ? moved.sets : moved.tweens;
    const std::string reason = scriptReason(tree, reading, events.empty() ? 0 : events[0]->line);
    if (moved.unknown)
      motions.leave(id, "motion that a script computes",
                    "stays at its position in the file; " + reason);
    else
      takeMoved(motions, timeline, id, moved, reason);
  }
}

void noteTriggered(RoleContext& context, const ScriptReading& reading, const Timeline& timeline) {
  for (const auto& [id, moved] : movedBy(context.tree, timeline)) {
    const auto& events = moved.tweens.empty() ? moved.sets : moved.tweens;
    if (!context.hasParts(id)) continue;
    const int line = events.empty() ? 0 : events.front()->line;
    context.level.noteUnmodelled(
        "motion that a touch or click starts", context.tree.path(id),
        "stays at its position in the file; " + scriptReason(context.tree, reading, line));
  }
}

}  // namespace

void movingFromScripts(RoleContext& context) {
  ScriptMotions motions(context);
  for (const Doings doings : kByCertainty) {
    context.eachTimeline(doings, [&](const ScriptReading& reading, const Timeline& timeline) {
      if (timeline.byItself())
        takeAll(context.tree, motions, reading, timeline);
      else
        noteTriggered(context, reading, timeline);
    });
    if (doings == Doings::certain) addSteps(context, motions);
  }
  motions.give();
}

}  // namespace obby::importer
