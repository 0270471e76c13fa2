// Moving and spinning parts whose scripts set poses in a loop or play tweens.
#include <algorithm>
#include <map>

#include "import/motion.h"
#include "import/pivot.h"
#include "import/pose_math.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

constexpr double kInstant = 1e-4;  // seconds

struct Moved {
  Pose rest;   // in the file
  Pose start;  // when the loop or the first tween begins
  std::vector<const ScriptEvent*> sets, tweens;
  std::vector<const ScriptEvent*> early;  // tweens before the loop
  Pose earlyStart;                        // when the first of them begins
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
  }
  moved.start = *event.frame;
}

// What the loop does not move goes on as it was begun before it.
void settleLoop(Moved& moved, bool forever) {
  moved.loops = forever && !(moved.sets.empty() && moved.tweens.empty());
  if (moved.loops || moved.early.empty()) return;
  moved.tweens.swap(moved.early);
  moved.start = moved.earlyStart;
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
    if (!event.frame) {
      moved.unknown = true;
    } else if (i < loop) {
      takeEarly(moved, event);
    } else if (event.kind == EventKind::set) {
      if (!timeline.forever && moved.tweens.empty()) moved.start = *event.frame;
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
      if (!event->tween.reverses) start = *event->frame;
      continue;
    }
    if (const auto spin = spinOfTween(start, *event))
      return spinning(*spin, start, moved.rest, event->time);
    Motion motion;
    motion.keys = {{0, start, Easing::linear, EasingDirection::out}};
    ScriptEvent once = *event;
    once.tween.repeats = 0;
    once.tween.reverses = false;
    appendTween(motion.keys, once, 0);
    motion.repeat = event->tween.reverses ? Repeat::pingPong : Repeat::loop;
    beginAt(motion, event->time);
    return motion;
  }
  return std::nullopt;
}

std::optional<Motion> tweenMotion(const Timeline& timeline, const Moved& moved) {
  if (moved.tweens.empty()) return std::nullopt;
  if (auto endless = endlessTween(moved)) return endless;
  Motion motion;
  motion.repeat = moved.loops ? Repeat::loop : Repeat::once;
  const double zero = moved.loops ? timeline.loopStart : 0;
  beginAt(motion, zero);  // what comes but once waits with its keys
  // In a loop the first round starts where the last one ends.
  const ScriptEvent& last = *moved.tweens.back();
  const Pose start = moved.loops && !last.tween.reverses ? *last.frame : moved.start;
  motion.keys = {{0, start, Easing::linear, EasingDirection::out}};
  for (const ScriptEvent* event : moved.tweens)
    appendTween(motion.keys, *event, event->time - zero);
  if (moved.loops && timeline.period > double(motion.keys.back().time))
    motion.keys.push_back(
        {float(timeline.period), motion.keys.back().pose, Easing::linear, EasingDirection::out});
  return motion;
}

// Seconds after which the samples of an open loop nearly repeat: those of a sine of the clock,
// whose period is no whole number of frames. Nothing if they never come within 1 % of their range.
std::optional<double> nearPeriod(const std::vector<PoseSample>& samples) {
  if (samples.size() < 8) return std::nullopt;
  const auto mismatch = [&](size_t a, size_t b) {
    return length(samples[a].pose.position - samples[b].pose.position) +
           length(rotationVector(samples[a].pose.rotation * inverse(samples[b].pose.rotation)));
  };
  float range = 0, best = 0;
  size_t bestAt = 0;
  for (size_t k = 2; k + 1 < samples.size(); ++k) {
    range = std::max(range, mismatch(1, k));
    const float now = mismatch(1, k) + mismatch(2, k + 1);
    if (k > 3 && (bestAt == 0 || now < best)) best = now, bestAt = k;
  }
  if (bestAt == 0 || best > 0.01f * range) return std::nullopt;
  return samples[bestAt].time - samples[1].time;
}

struct LoopMotion {
  Motion motion;
  bool open = false;  // never repeats while it was followed
  double period = 0;
};

std::optional<LoopMotion> loopMotion(const Timeline& timeline, const Moved& moved) {
  if (moved.sets.empty() || !timeline.forever || !(timeline.period > 0)) return std::nullopt;
  std::vector<PoseSample> samples;
  for (const ScriptEvent* event : moved.sets)
    samples.push_back({event->time - timeline.loopStart, *event->frame});
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

void noteUnknown(RoleContext& context, InstanceId id, const std::string& reason) {
  if (context.hasParts(id))
    context.level.noteUnmodelled("motion that a script computes", context.tree.path(id),
                                 "left where the file has it; " + reason);
}

void giveAll(RoleContext& context, const ScriptReading& reading, const Timeline& timeline) {
  for (const auto& [id, moved] : movedBy(context.tree, timeline)) {
    const auto& events = moved.tweens.empty() ? moved.sets : moved.tweens;
    std::string reason = scriptReason(context.tree, reading, events.empty() ? 0 : events[0]->line);
    if (moved.unknown) {
      noteUnknown(context, id, reason);
      continue;
    }
    auto motion = tweenMotion(timeline, moved);
    bool open = false;
    if (!motion) {
      const auto loop = loopMotion(timeline, moved);
      if (!loop) continue;
      motion = loop->motion;
      open = loop->open;
      if (open) reason += " (starts over after " + std::to_string(int(loop->period)) + " s)";
    }
    const bool unsure = timeline.vague || std::any_of(events.begin(), events.end(),
                                                      [](const auto* e) { return e->unsure; });
    giveMotion(context, id, *motion, reason, open || unsure);
    for (const ScriptEvent* event : events) hideMarker(context, event->from, id);
  }
}

}  // namespace

void movingFromScripts(RoleContext& context) {
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines) {
      if (timeline.byItself()) {
        giveAll(context, reading, timeline);
        continue;
      }
      for (const auto& [id, moved] : movedBy(context.tree, timeline)) {
        const auto& events = moved.tweens.empty() ? moved.sets : moved.tweens;
        if (!context.hasParts(id)) continue;
        const int line = events.empty() ? 0 : events.front()->line;
        context.level.noteUnmodelled(
            "motion that a touch or click starts", context.tree.path(id),
            "left where the file has it; " + scriptReason(context.tree, reading, line));
      }
    }
}

}  // namespace obby::importer
