// The motion of a tween, as TweenService makes it: each goal property goes its eased way by itself,
// so that an Orientation turns by as many degrees as its goal says.
#pragma once

#include <vector>

#include "import/script_reading.h"

namespace obby::importer {

// Repeats of a tween that are done, unless it goes on for longer than a motion can: that one counts
// as endless.
constexpr int kMostTweenRepeats = 100;

// Whether both set where the part is, or both which way it is turned.
bool setTheSame(const ScriptEvent& a, const ScriptEvent& b);

// Of the CFrame as a whole: the engine knows it as another property than its pieces.
bool isWhole(const ScriptEvent& event);

// Seconds at which a tween that nothing stops is over, an endless one with its first round.
double endOf(const ScriptEvent& event);

// The share 0..1 of its way at which a tween is, `since` seconds after it was played: 0 until its
// delay is over, back again where it reverses.
double shareAfter(const TweenTiming& timing, double since);

// What the easing of a tween makes of a share 0..1; it may come out of that range.
float easedShare(const TweenTiming& timing, double share);

// The pose that a tween from `from` leads to; what the event does not set stays.
Pose goalOf(const Pose& from, const ScriptEvent& event);

// Of a way back, which goes through time backwards.
EasingDirection reversed(EasingDirection direction);

// The pose after a share 0..1 of a tween's seconds from `from` to its goal.
Pose onTheWay(const Pose& from, const ScriptEvent& event, double share);

// The pose once a tween is over or stopped, or a pose is set.
Pose poseAfter(const Pose& from, const ScriptEvent& event);

// Appends all rounds of a tween of poses, played `time` seconds after the first key, to `keys`,
// which are not empty; the pose before it is held until it begins. `event` has its frame.
void appendTween(std::vector<MotionKey>& keys, const ScriptEvent& event, double time);

// An endless tween from `start` on, which has gone on for ever.
Motion endlessMotion(const Pose& start, const ScriptEvent& event);

// Lets what `motion` takes from place to place spin as well, from `start` at `begin` seconds on as
// if for ever. The keys turn by nothing else.
void addSpin(Motion& motion, const Spin& spin, const Mat3& start, double begin);

// The turn of an endless tween that starts over at each whole turn, in the frame of `start`;
// nothing if it is anything else.
std::optional<Spin> spinOfTween(const Pose& start, const ScriptEvent& event);

}  // namespace obby::importer
