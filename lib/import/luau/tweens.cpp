// Tweens of the script reader: when they play and end, and what they make of a property on the way.
#include <algorithm>
#include <limits>
#include <utility>

#include "import/luau/reader.h"
#include "import/motion_room.h"
#include "import/pivot.h"
#include "import/pose_math.h"
#include "import/tween_motion.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kPlayedPerStep = 64;  // tweens looked through
constexpr size_t kGoalsPerStep = 8;    // of those looked through
constexpr double kDone = 1e-3;         // seconds before its end that a tween is over

// A share of the way from a value to the goal of a tween; unknown where the text tells neither.
Datum valueBetween(const Datum& from, const ScriptEvent& goal, float share) {
  const auto* number = from.as<double>();
  const auto* vector = from.as<Vector>();
  if (number && goal.number) return {*number + (*goal.number - *number) * double(share)};
  if (vector && goal.vector)
    return {Vector{vector->value + (*goal.vector - vector->value) * share, kNoInstance}};
  return {};
}

bool isPose(const ScriptEvent& event) { return event.property == "CFrame" && event.frame; }

// Whether each of them, as it is played, puts an end to the other.
bool shareGoals(const Tween& a, const Tween& b) {
  return a.target == b.target && a.target != kNoInstance &&
         std::any_of(a.goals.begin(), a.goals.end(),
                     [&](const auto& goal) { return b.goals.count(goal.first) > 0; });
}

void forget(Pose& pose, bool place, bool turn) {
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  const Vec3 unknown = {kUnknown, kUnknown, kUnknown};
  if (place) pose.position = unknown;
  if (turn) pose.rotation = {unknown, unknown, unknown};
}

}  // namespace

// Whether it was played, goes on, and nothing has put an end to it.
bool Reader::isPlaying(const Tween* tween) {
  spend(played_.size() / kPlayedPerStep);
  for (auto before = played_.rbegin(); before != played_.rend(); ++before) {
    const Tween* other = before->tween;
    if (before->time > time_ + kDone) continue;  // what is delayed stands before what comes sooner
    if (other == tween)
      return !before->stopped &&
             (tween->timing.repeats < 0 || time_ < before->time + tween->timing.total() - kDone);
    if (other->target != tween->target) continue;
    spend(other->goals.size() / kGoalsPerStep);
    if (shareGoals(*other, *tween)) return false;
  }
  return false;
}

// Null if it was not played so far.
Played* Reader::lastPlayed(const Tween* tween) {
  const auto last = std::find_if(played_.rbegin(), played_.rend(), [&](const Played& before) {
    return before.tween == tween && before.time <= time_ + kDone;
  });
  return last == played_.rend() ? nullptr : &*last;
}

double Reader::secondsLeft(const Tween* tween) {
  const double total = tween->timing.total();
  if (tween->timing.repeats < 0 || !isPlaying(tween)) return total;
  return lastPlayed(tween)->time + total - time_;
}

// What it tweens stays where it is by then. After a pause it can go on.
void Reader::stop(const Tween* tween, bool pauses) {
  Played* const maybe = isUnsure() && isPlaying(tween) ? lastPlayed(tween) : nullptr;
  if (maybe) maybe->doubt = std::numeric_limits<int>::max();
  if (isUnsure()) return;
  if (!pauses) paused_.erase(tween);
  if (!isPlaying(tween)) return;
  Played& last = *lastPlayed(tween);
  last.stopped = true;
  last.paused = pauses;
  if (pauses) paused_[tween] = time_ - last.time;
  const size_t end = std::min(last.event + last.events, timeline_.events.size());
  for (size_t i = last.event; i < end; ++i) {
    timeline_.events[i].until = time_;
    halt(tween, timeline_.events[i]);
  }
}

void Reader::halt(const Tween* tween, const ScriptEvent& event) {
  const auto found = going_.find({event.target, event.property});
  if (found == going_.end()) return;
  auto& all = found->second;
  const auto going =
      std::find_if(all.begin(), all.end(), [&](const Going& g) { return g.tween == tween; });
  if (going == all.end()) return;
  if (isPose(event)) {
    Pose pose = frameOf(event.target);
    const Pose way = poseOf(*going);
    if (event.places) pose.position = way.position;
    if (event.turns) pose.rotation = way.rotation;
    write(event.target, event.property, {Frame{pose, kNoInstance}});
  } else if (Datum value = valueOf(*going); !value.as<Unknown>()) {
    write(event.target, event.property, std::move(value));
  }
  all.erase(going);
}

// Whether what the end of a tween plays has been played before: then it comes round again.
bool Reader::closesChain(const Tween* tween) {
  if (!finishing_ || timeline_.forever) return false;
  const auto before = std::find_if(played_.begin(), played_.end(), [&](const Played& played) {
    return played.tween == tween && !played.paused;
  });
  if (before == played_.end()) return false;
  timeline_.forever = true;
  timeline_.loopStart = before->time;
  timeline_.loopEvent = before->event;
  timeline_.period = time_ - before->time;
  return true;
}

// Playing what plays already does nothing.
void Reader::play(Tween* tween, int line) {
  if (closesChain(tween) || isPlaying(tween)) return;
  vague_ = vague_ || !tween->timing.known;
  const auto paused = paused_.find(tween);
  const double done = paused == paused_.end() ? 0 : paused->second;
  paused_.erase(tween);
  played_.push_back({tween, time_ - done, timeline_.events.size()});
  played_.back().doubt = unsure_;
  if (tween->target == kNoInstance || !spend(tween->goals.size())) return;
  if (!(done > 0)) keepStart(*tween);
  const size_t first = timeline_.events.size();
  const bool part = tree_.isPart(tween->target);
  if (part) setPoseGoals(*tween, line);
  for (const auto& [name, value] : tween->goals)  // a colour is another one until it gets there
    if (!part || !isPoseProperty(name))
      setInstance(tween->target, name, isColor(value) ? Datum{} : value, line);
  for (size_t i = first; i < timeline_.events.size(); ++i)
    takeUp(*tween, timeline_.events[i], done);
  played_.back().events = timeline_.events.size() - first;
}

void Reader::keepStart(Tween& tween) {
  const bool part = tree_.isPart(tween.target);
  tween.began.clear();
  bool pose = false;
  for (const auto& [name, value] : tween.goals) {
    if (part && isPoseProperty(name))
      pose = true;
    else if (value.as<double>() || value.as<Vector>())
      tween.began[name] = instanceField(tween.target, name);
  }
  if (!pose) return;
  const Pose last = frameOf(tween.target);
  tween.from = tweenedFrame(tween.target, last);
  if (!isFinite(tween.from.position)) tween.from.position = last.position;
  if (!isFinite(tween.from.rotation.x)) tween.from.rotation = last.rotation;
}

// `done`: seconds before a pause. Repeats that outlast all motions are as good as endless.
void Reader::takeUp(const Tween& tween, ScriptEvent& event, double done) {
  event.kind = EventKind::tween;
  event.tween = tween.timing;
  const bool outlasts = tween.timing.repeats > 0 && tween.timing.total() > double(kLongestMotion);
  if (outlasts) event.tween.repeats = -1;
  event.which = tween.number;
  if (done > event.tween.delay)
    event.done = done;
  else
    event.tween.delay -= done;
  drive(tween, event);
  if (tween.timing.reverses && event.tween.repeats >= 0) comeBack(tween, event);
}

// Puts an end to what has set the same so far.
void Reader::drive(const Tween& tween, const ScriptEvent& event) {
  const bool pose = isPose(event);
  if (!pose && tween.began.count(event.property) == 0) return;
  if (!pose && event.tween.repeats < 0) turned_.insert({event.target, event.property});
  auto& all = going_[{event.target, event.property}];
  bool clashes = false;
  std::erase_if(all, [&](const Going& other) {
    const bool same = !pose || setTheSame(other.goal, event);
    clashes = clashes || (pose && same && isOn(other) && isWhole(other.goal) != isWhole(event));
    return same || !isOn(other);
  });
  all.push_back({&tween, event, followed_, clashes});
}

// Once a tween that reverses is over, all is as it was when that began.
void Reader::comeBack(const Tween& tween, const ScriptEvent& event) {
  if (isPose(event)) {
    Pose pose = *event.frame;
    if (event.places) pose.position = tween.from.position;
    if (event.turns) pose.rotation = tween.from.rotation;
    write(event.target, event.property, {Frame{pose, kNoInstance}});
    return;
  }
  const auto before = tween.began.find(event.property);
  if (before != tween.began.end() && !before->second.as<Unknown>())
    write(event.target, event.property, before->second);
}

// What the end of each tween sets off. A tween that plays again closes a loop.
void Reader::finishTweens() {
  constexpr size_t kMaxChain = 64;
  finishing_ = true;
  for (size_t i = 0; i < played_.size() && !timeline_.forever; ++i) {
    const Played played = played_[i];
    if (i >= kMaxChain && !played.tween->completed.empty()) reading_.exhausted = true;
    if (i >= kMaxChain || played.tween->timing.repeats < 0 || played.paused) continue;
    const double end = played.time + played.tween->timing.total();
    time_ = end - 2 * kDone;
    const bool whole = isPlaying(played.tween);  // else another one may have put an end to it
    time_ = end;
    const auto completed = played.tween->completed;  // what is called may connect more
    Datum state;
    if (whole) state = {Library{"Enum.PlaybackState.Completed"}};
    if (played.stopped) state = {Library{"Enum.PlaybackState.Cancelled"}};
    for (const Closure& closure : completed) call(closure, {state});
  }
  played_.clear();
  paused_.clear();
  finishing_ = false;
}

// What is tweened round by round is somewhere on its way whenever another timeline asks.
void Reader::leaveGoing() {
  if (!timeline_.forever) return;
  for (size_t i = timeline_.loopEvent; i < timeline_.events.size(); ++i) {
    const ScriptEvent& event = timeline_.events[i];
    if (event.kind != EventKind::tween || event.tween.repeats < 0) continue;
    const auto found = going_.find({event.target, event.property});
    if (found == going_.end()) continue;
    for (Going& going : found->second) going.again = going.again || going.goal.which == event.which;
  }
}

// Once the script has waited for something that may be their end, tweens that end are over.
void Reader::endGoing() {
  for (auto& [key, all] : going_)
    std::erase_if(all,
                  [](const Going& going) { return going.goal.tween.repeats >= 0 && !going.again; });
}

// What comes but once is over by the time of an endless loop after it, in all its rounds but the
// first ones, and after a wait that the text does not tell, which may be a wait for its end.
bool Reader::isOn(const Going& going) const {
  const TweenTiming& timing = going.goal.tween;
  const double on = secondsOn(going);
  if (timing.repeats < 0) return on > -kDone;
  if (vague_) return false;
  const bool ofTheLoop =
      going.timeline == followed_ && going.goal.time >= timeline_.loopStart - kDone;
  if (timeline_.forever && !ofTheLoop) return false;
  return on > -kDone && on < timing.total() - kDone;
}

Pose Reader::poseOf(const Going& going) const {
  return onTheWay(going.tween->from, going.goal, shareAfter(going.goal.tween, secondsOn(going)));
}

Datum Reader::valueOf(const Going& going) const {
  const auto from = going.tween->began.find(going.goal.property);
  if (from == going.tween->began.end()) return {};
  const TweenTiming& timing = going.goal.tween;
  const float share = easedShare(timing, shareAfter(timing, secondsOn(going)));
  return valueBetween(from->second, going.goal, share);
}

Pose Reader::tweenedFrame(InstanceId id, Pose pose) const {
  if (going_.empty()) return pose;
  const InstanceId part = tree_.isPart(id) ? id : primaryPartOf(tree_, id);
  const auto found = going_.find({part, "CFrame"});
  if (found == going_.end()) return pose;
  for (const Going& going : found->second) {
    const bool all = going.clashes && isOn(going);
    if (going.again || all) forget(pose, all || going.goal.places, all || going.goal.turns);
    if (going.again || all || !isOn(going)) continue;
    const Pose way = poseOf(going);
    if (going.goal.places) pose.position = way.position;
    if (going.goal.turns) pose.rotation = way.rotation;
  }
  return pose;
}

std::optional<Datum> Reader::tweenedValue(InstanceId id, const std::string& name) const {
  if (going_.empty()) return std::nullopt;
  const auto found = going_.find({id, name});
  if (found == going_.end()) return std::nullopt;
  for (const Going& going : found->second) {
    if (going.again) return Datum{};
    if (isOn(going)) return valueOf(going);
  }
  return std::nullopt;
}

}  // namespace obby::importer::luau
