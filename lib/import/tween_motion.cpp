// Keys are joined by the shortest turn, so a turn that may not be the shortest gets keys on its
// way.
#include "import/tween_motion.h"

#include <algorithm>
#include <cmath>

#include "import/motion.h"
#include "import/pose_math.h"
#include "level/motion_tables.h"

namespace obby::importer {
namespace {

constexpr float kUnturned = 0.01f;    // degrees
constexpr float kShortTurn = 90.01f;  // degrees that the shortest turn is sure to follow
constexpr double kTurnOfAKey = 60;    // degrees
constexpr double kKeysOfAnEasing = 120;
constexpr double kSteepest = 8;     // an easing is so many times faster than its mean, now and then
constexpr double kMostKeys = 1500;  // of all rounds
constexpr double kTicks = 60;       // a second
constexpr float kSamePlace = 1e-3f;  // studs

// How a tween turns: degrees about each axis, or nothing where its goal is a pose.
Vec3 turnOf(const Pose& from, const ScriptEvent& event) {
  return event.orientation ? *event.orientation - toOrientation(from.rotation) : Vec3{};
}

int axesOf(Vec3 turn) {
  return (absf(turn.x) > kUnturned) + (absf(turn.y) > kUnturned) + (absf(turn.z) > kUnturned);
}

// The way from one pose to the goal of a tween.
class Way {
 public:
  Way(const Pose& from, const ScriptEvent& event, int legs)
      : from_(from), goal_(goalOf(from, event)), event_(event) {
    const Vec3 turn = turnOf(from, event);
    const double degrees = absf(turn.x) + absf(turn.y) + absf(turn.z);
    const int axes = axesOf(turn);
    if (degrees <= double(kShortTurn) && axes < 2) return;
    const bool even = axes < 2 && event.tween.easing == Easing::linear;
    const double share = std::ceil(degrees / kTurnOfAKey);
    const double wanted = even ? share : std::max(kSteepest * share, kKeysOfAnEasing);
    const double ticks = std::ceil(event.tween.seconds * kTicks);
    steps_ = int(std::max(1.0, std::min({wanted, ticks, kMostKeys / legs})));
  }

  // From `time` on; a way back goes through time backwards.
  void append(std::vector<MotionKey>& keys, double time, bool back) const {
    const TweenTiming& t = event_.tween;
    const Pose& last = back ? from_ : goal_;
    for (int i = 1; i < steps_; ++i) {
      const double share = double(i) / steps_;
      keys.push_back({float(time + t.seconds * share),
                      onTheWay(from_, event_, back ? 1 - share : share), Easing::linear,
                      EasingDirection::out});
    }
    const float end = float(time + t.seconds);
    if (steps_ > 1)
      keys.push_back({end, last, Easing::linear, EasingDirection::out});
    else
      keys.push_back({end, last, t.easing, back ? reversed(t.direction) : t.direction});
  }

 private:
  const Pose from_, goal_;
  const ScriptEvent& event_;
  int steps_ = 1;
};

}  // namespace

EasingDirection reversed(EasingDirection direction) {
  if (direction == EasingDirection::inOut) return direction;
  return direction == EasingDirection::in ? EasingDirection::out : EasingDirection::in;
}

bool setTheSame(const ScriptEvent& a, const ScriptEvent& b) {
  return (a.places && b.places) || (a.turns && b.turns);
}

bool isWhole(const ScriptEvent& event) { return event.places && event.turns && !event.orientation; }

double endOf(const ScriptEvent& event) { return event.time + event.tween.total() - event.done; }

double shareAfter(const TweenTiming& timing, double since) {
  const double gone = since - timing.delay;
  if (!(gone > 0)) return 0;
  const double seconds = std::max(timing.seconds, 1 / kTicks);
  const double legs = timing.reverses ? 2 : 1;
  if (timing.repeats >= 0 && gone >= seconds * legs * (timing.repeats + 1))
    return timing.reverses ? 0 : 1;
  const double leg = std::floor(gone / seconds);
  const double share = gone / seconds - leg;
  return timing.reverses && std::fmod(leg, 2.0) > 0.5 ? 1 - share : share;
}

float easedShare(const TweenTiming& timing, double share) {
  return float(
      level::ease(schema::Easing(timing.easing), schema::EasingDirection(timing.direction), share));
}

Pose goalOf(const Pose& from, const ScriptEvent& event) {
  Pose goal = *event.frame;
  if (!event.places) goal.position = from.position;
  if (!event.turns) goal.rotation = from.rotation;
  return goal;
}

Pose onTheWay(const Pose& from, const ScriptEvent& event, double share) {
  const float eased = easedShare(event.tween, share);
  Pose pose = between(from, goalOf(from, event), eased);
  if (event.orientation)
    pose.rotation = fromOrientation(toOrientation(from.rotation) + turnOf(from, event) * eased);
  return pose;
}

Pose poseAfter(const Pose& from, const ScriptEvent& event) {
  if (event.kind != EventKind::tween) return goalOf(from, event);
  if (std::isfinite(event.until))
    return onTheWay(from, event, shareAfter(event.tween, event.until - event.time + event.done));
  return event.tween.reverses ? from : goalOf(from, event);
}

void appendTween(std::vector<MotionKey>& keys, const ScriptEvent& event, double time) {
  const TweenTiming& t = event.tween;
  const Pose from = keys.back().pose;
  const int rounds = std::clamp(t.repeats, 0, kMostTweenRepeats) + 1;
  const Way way(from, event, t.reverses ? 2 * rounds : rounds);
  double now = std::max(time + t.delay, double(keys.back().time));
  const auto hold = [&] {
    keys.push_back({float(now), from, Easing::linear, EasingDirection::out});
  };
  if (now > double(keys.back().time)) hold();
  for (int round = 0; round < rounds; ++round) {
    if (round > 0 && !t.reverses) hold();
    way.append(keys, now, false);
    now += t.seconds;
    if (!t.reverses) continue;
    way.append(keys, now, true);
    now += t.seconds;
  }
}

Motion endlessMotion(const Pose& start, const ScriptEvent& event) {
  Motion motion;
  motion.keys = {{0, start, Easing::linear, EasingDirection::out}};
  ScriptEvent once = event;
  once.tween.repeats = 0;
  once.tween.reverses = false;
  appendTween(motion.keys, once, 0);
  motion.repeat = event.tween.reverses ? Repeat::pingPong : Repeat::loop;
  beginAt(motion, event.time - event.done);
  return motion;
}

void addSpin(Motion& motion, const Spin& spin, const Mat3& start, double begin) {
  // The simulator's spin has come as far as the offset of the motion says.
  const double ahead = -begin - double(motion.offset);
  const Mat3 turned = start * rotationAbout(spin.axis, double(spin.speed) * ahead);
  for (MotionKey& key : motion.keys) key.pose.rotation = turned;
  motion.spin = spin;
}

std::optional<Spin> spinOfTween(const Pose& start, const ScriptEvent& event) {
  const TweenTiming& t = event.tween;
  const bool even =
      t.repeats < 0 && !t.reverses && t.delay == 0 && t.seconds > 0 && t.easing == Easing::linear;
  const Pose goal = goalOf(start, event);
  if (!even || length(goal.position - start.position) > kSamePlace) return std::nullopt;
  const Vec3 turn = turnOf(start, event);
  const float degrees = length(turn);
  if (axesOf(turn) != 1 || absf(std::remainder(degrees, 360.0f)) > kUnturned) return std::nullopt;
  constexpr float kSample = 10;  // degrees: the axis is the same for all
  const Vec3 way = toOrientation(start.rotation) + turn * (kSample / degrees);
  Spin spin;
  spin.axis = normalize(rotationVector(inverse(start.rotation) * fromOrientation(way)));
  spin.speed = float(double(degrees) * 3.14159265358979323846 / 180 / t.seconds);
  return spin;
}

}  // namespace obby::importer
