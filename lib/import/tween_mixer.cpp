// Between two changes each tween is on one leg of its way.
#include "import/tween_mixer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "import/frame_time.h"
#include "import/tween_motion.h"
#include "level/rotation.h"

namespace obby::importer {
namespace {

constexpr double kSameMoment = 1e-4;  // seconds
constexpr double kSamples = 30;       // a second, of a way that is not even
constexpr int kMostChanges = 10000;   // from change to change: bounds the work
constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr float kStill = 1e-4f;  // studs, radians

double secondsOf(const ScriptEvent& event) { return std::max(event.tween.seconds, kFrame); }

bool differ(const Pose& a, const Pose& b) {
  return length(a.position - b.position) > kStill ||
         length(rotationVector(a.rotation * inverse(b.rotation))) > kStill;
}

double legOf(const RunningTween& tween, double time) {
  return std::max(0.0, std::floor((time - tween.begin) / secondsOf(*tween.event)));
}

bool goesBack(const RunningTween& tween, double leg) {
  return tween.event->tween.reverses && std::fmod(leg, 2.0) > 0.5;
}

}  // namespace

bool RunningTween::isEndless() const { return end == kNoEnd; }

double roundOfTween(const ScriptEvent& event) {
  return secondsOf(event) * (event.tween.reverses ? 2 : 1);
}

std::vector<RunningTween> TweenMixer::endless() const {
  std::vector<RunningTween> found;
  for (const RunningTween& tween : running_)
    if (tween.isEndless()) found.push_back(tween);
  return found;
}

void TweenMixer::record() {
  recording_ = true;
  zero_ = time_;
  keys_.clear();
  push(time_, now_);
}

void TweenMixer::take(const ScriptEvent& event, double time) {
  advance(time);
  if (event.kind == EventKind::set) {
    if (event.places && !isDriven(&ScriptEvent::places)) now_.position = event.frame->position;
    if (event.turns && !isDriven(&ScriptEvent::turns)) now_.rotation = event.frame->rotation;
    return;
  }
  std::erase_if(running_, [&](const RunningTween& other) {
    const bool same = setTheSame(*other.event, event);
    failed_ = failed_ || (same && isWhole(*other.event) != isWhole(event));
    return same;
  });
  RunningTween tween;
  tween.event = &event;
  tween.begin = time + event.tween.delay - event.done;
  const double rounds = event.tween.repeats < 0 ? kNoEnd : event.tween.repeats + 1;
  const double stop = std::max(time + (event.until - event.time), tween.begin);
  tween.end = std::min(tween.begin + roundOfTween(event) * rounds, stop);
  if (event.done > 0) resume(tween);
  running_.push_back(tween);
  settle();
}

// After a pause it goes on along the way that it was on.
void TweenMixer::resume(RunningTween& tween) {
  const auto paused = std::find_if(stopped_.rbegin(), stopped_.rend(), [&](const auto& other) {
    return other.event->which == tween.event->which;
  });
  failed_ = failed_ || paused == stopped_.rend();
  if (failed_) return;
  tween.begun = paused->begun;
  tween.from = paused->from;
}

void TweenMixer::advance(double until) {
  while (time_ < until - kSameMoment && !failed()) {
    double next = until;
    for (const RunningTween& tween : running_) next = std::min(next, changeOf(tween));
    step(next);
    tooLong_ = tooLong_ || ++steps_ > kMostChanges;
  }
}

void TweenMixer::beginAll() {
  double last = time_;
  for (const RunningTween& tween : running_) last = std::max(last, tween.begin);
  advance(last);
}

void TweenMixer::finish() {
  double last = time_;
  for (const RunningTween& tween : running_)
    if (!tween.isEndless()) last = std::max(last, tween.end);
  advance(last);
}

std::vector<MotionKey> TweenMixer::keys() {
  if (differ(now_, keys_.back().pose)) push(time_, now_);
  return std::move(keys_);
}

bool TweenMixer::isDriven(bool ScriptEvent::*what) const {
  return std::any_of(running_.begin(), running_.end(),
                     [&](const RunningTween& tween) { return tween.begun && tween.event->*what; });
}

// When it begins, turns round, starts over or ends.
double TweenMixer::changeOf(const RunningTween& tween) const {
  if (!tween.begun) return tween.begin;
  const double seconds = secondsOf(*tween.event);
  const double leg = std::floor((time_ - tween.begin + kSameMoment) / seconds) + 1;
  return std::min(tween.end, tween.begin + leg * seconds);
}

void TweenMixer::step(double to) {
  const double middle = (time_ + to) / 2;
  if (recording_) sample(to, middle);
  now_ = poseAt(to, middle);
  time_ = to;
  settle();
}

void TweenMixer::settle() {
  std::erase_if(running_, [&](const RunningTween& tween) {
    const bool over = tween.begun && tween.end <= time_ + kSameMoment;
    if (over && std::isfinite(tween.event->until)) stopped_.push_back(tween);
    return over;
  });
  for (RunningTween& tween : running_) {
    if (tween.begun || tween.begin > time_ + kSameMoment) continue;
    tween.begun = true;
    tween.from = now_;
  }
}

// `middle` is a time in the same leg of all tweens.
Pose TweenMixer::poseAt(double time, double middle) const {
  Pose pose = now_;
  for (const RunningTween& tween : running_) {
    if (!tween.begun) continue;
    const double leg = legOf(tween, middle);
    double share = std::clamp((time - tween.begin) / secondsOf(*tween.event) - leg, 0.0, 1.0);
    if (goesBack(tween, leg)) share = 1 - share;
    const Pose way = onTheWay(tween.from, *tween.event, share);
    if (tween.event->places) pose.position = way.position;
    if (tween.event->turns) pose.rotation = way.rotation;
  }
  return pose;
}

bool TweenMixer::isEven() const {
  return std::all_of(running_.begin(), running_.end(), [](const RunningTween& tween) {
    return !tween.begun ||
           (tween.event->tween.easing == Easing::linear && !tween.event->orientation);
  });
}

// The tween that makes one leg of its way, from end to end, while no other goes on; null: none.
const RunningTween* TweenMixer::oneLeg(double to, double middle) const {
  const RunningTween* only = nullptr;
  for (const RunningTween& tween : running_) {
    if (!tween.begun) continue;
    if (only || tween.event->orientation) return nullptr;
    only = &tween;
  }
  if (!only) return nullptr;
  const double seconds = secondsOf(*only->event);
  const double from = only->begin + legOf(*only, middle) * seconds;
  const bool whole =
      std::abs(time_ - from) < kSameMoment && std::abs(to - from - seconds) < kSameMoment;
  return whole ? only : nullptr;
}

void TweenMixer::sample(double to, double middle) {
  const RunningTween* const leg = oneLeg(to, middle);
  const bool one = leg || isEven();
  const double steps = one ? 1 : std::max(1.0, std::ceil((to - time_) * kSamples));
  tooLong_ = tooLong_ || double(keys_.size()) + steps > kMostMixedKeys;
  if (tooLong_) return;
  const Pose first = poseAt(time_, middle);
  if (differ(first, keys_.back().pose)) push(time_, first);  // a jump
  for (int i = 1; i <= int(steps); ++i) {
    const double time = time_ + (to - time_) * i / steps;
    push(time, poseAt(time, middle));
  }
  if (!leg) return;
  const TweenTiming& timing = leg->event->tween;
  const bool back = goesBack(*leg, legOf(*leg, middle));
  keys_.back().easing = timing.easing;
  keys_.back().direction = back ? reversed(timing.direction) : timing.direction;
}

void TweenMixer::push(double time, const Pose& pose) {
  keys_.push_back({float(time - zero_), pose, Easing::linear, EasingDirection::out});
}

}  // namespace obby::importer
