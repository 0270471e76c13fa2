// Which of the motions that a level can have mixed tweens are.
#include "import/tween_mix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "import/motion.h"
#include "import/tween_mixer.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

constexpr double kSame = 1e-4;         // seconds
constexpr size_t kRounds = 24;         // of a loop, until each goes as the one before
constexpr size_t kMostTaken = 100000;  // events in all rounds: bounds the work
constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr double kWhole = 1e-3;  // off a whole number

// What a mixer could not do.
Mixed failure(const TweenMixer& mixer) { return {std::nullopt, mixer.tooLong()}; }

Mixed ofALoop(const Pose& start, const PoseEvents& events, double zero, double period) {
  // It comes nearer to its steady round with each; from where one ends on, it is near at once.
  Pose last = start;
  for (const ScriptEvent* event : events) last = poseAfter(last, *event);
  TweenMixer mixer(last);
  const int rounds = int(std::clamp<size_t>(kMostTaken / events.size(), 2, kRounds));
  for (int round = 0; round < rounds && !mixer.failed(); ++round) {
    const double begin = round * period;
    if (round + 1 == rounds) mixer.record();
    for (const ScriptEvent* event : events) mixer.take(*event, begin + event->time - zero);
    mixer.advance(begin + period);
  }
  if (mixer.failed()) return failure(mixer);
  Motion motion;
  motion.keys = mixer.keys();
  beginAt(motion, zero);
  return {motion};
}

// All events but `without` make keys.
Mixed ofKeys(const Pose& start, const PoseEvents& events, const ScriptEvent* without) {
  TweenMixer mixer(start);
  mixer.record();
  for (const ScriptEvent* event : events)
    if (event != without) mixer.take(*event, event->time);
  mixer.finish();
  if (mixer.failed()) return failure(mixer);
  Motion motion;
  motion.repeat = Repeat::once;
  motion.keys = mixer.keys();
  return {motion};
}

// The pose from which an endless tween goes on, once scripts have set beside it what it does not
// drive. Nothing where more than that follows it.
std::optional<Pose> settledStart(const PoseEvents& events, const RunningTween& endless) {
  Pose from = endless.from;
  auto next = std::find(events.begin(), events.end(), endless.event);
  while (next != events.end() && ++next != events.end()) {
    const ScriptEvent& event = **next;
    if (event.kind != EventKind::set) return std::nullopt;
    if (event.places && !endless.event->places) from.position = event.frame->position;
    if (event.turns && !endless.event->turns) from.rotation = event.frame->rotation;
  }
  return from;
}

// What goes on for ever once all else is over, or turns for ever beside it.
Mixed withEndless(const Pose& start, const PoseEvents& events, const RunningTween& endless) {
  if (const auto spin = spinOfTween(endless.from, *endless.event)) {
    Mixed mixed = ofKeys(start, events, endless.event);
    if (mixed.motion) addSpin(*mixed.motion, *spin, endless.from.rotation, endless.begin);
    return mixed;
  }
  const bool alone = std::all_of(events.begin(), events.end(), [&](const ScriptEvent* event) {
    const double over = event->kind == EventKind::set ? event->time : endOf(*event);
    const double end = std::min(over, event->until);
    return setTheSame(*event, *endless.event) || end <= endless.begin + kSame;
  });
  const auto from = settledStart(events, endless);
  if (!alone || !from) return {};
  return {endlessMotion(*from, *endless.event)};
}

// One turns for ever while the other goes from place to place, or both have a common round.
Mixed withBoth(TweenMixer& mixer, const RunningTween& a, const RunningTween& b) {
  for (const auto& [turns, goes] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const auto spin = spinOfTween(turns->from, *turns->event);
    if (!spin) continue;
    Motion motion = endlessMotion({goes->from.position, turns->from.rotation}, *goes->event);
    addSpin(motion, *spin, turns->from.rotation, turns->begin);
    return {motion};
  }
  const double longer = std::max(roundOfTween(*a.event), roundOfTween(*b.event));
  const double ratio = longer / std::min(roundOfTween(*a.event), roundOfTween(*b.event));
  if (std::abs(ratio - std::round(ratio)) > kWhole) return {};
  const double begin = mixer.clock();
  mixer.record();
  mixer.advance(begin + longer);
  if (mixer.failed()) return failure(mixer);
  Motion motion;
  motion.keys = mixer.keys();
  beginAt(motion, begin);
  return {motion};
}

}  // namespace

bool isMixed(const PoseEvents& events, double period) {
  double end = 0;
  for (const ScriptEvent* event : events) {
    const bool endless = event->tween.repeats < 0;
    const double own = endless ? kForEver : endOf(*event);
    const bool whole = event->done == 0 && event->until >= own - kSame;
    if (event->kind == EventKind::set || event->time < end - kSame || !whole) return true;
    end = own;
  }
  return period > 0 && end > events.front()->time + period + kSame;
}

Mixed mixedMotion(const Pose& start, const PoseEvents& events, double zero, double period) {
  if (period > 0) return ofALoop(start, events, zero, period);
  TweenMixer mixer(start);
  for (const ScriptEvent* event : events) mixer.take(*event, event->time);
  mixer.beginAll();
  const std::vector<RunningTween> endless = mixer.endless();
  if (mixer.failed()) return failure(mixer);
  if (endless.empty()) return ofKeys(start, events, nullptr);
  if (endless.size() == 1) return withEndless(start, events, endless[0]);
  return withBoth(mixer, endless[0], endless[1]);
}

}  // namespace obby::importer
