// Follows the tweens of one part from one change to the next, and samples the ways between.
#pragma once

#include <vector>

#include "import/script_reading.h"

namespace obby::importer {

// A tween that goes on, with seconds of the mixer's clock.
struct RunningTween {
  const ScriptEvent* event = nullptr;
  double begin = 0, end = 0;
  bool begun = false;
  Pose from;  // once it has begun

  bool isEndless() const;
};

// Seconds of one round of a tween, there and, if it reverses, back: a frame or more a way.
double roundOfTween(const ScriptEvent& event);

// Of the motion that a mixer records; one of more is too long.
constexpr int kMostMixedKeys = 3000;

class TweenMixer {
 public:
  explicit TweenMixer(const Pose& start) : now_(start) {}

  double clock() const { return time_; }
  // True where the engine would let two tweens of the same way go on, or of too many changes or
  // keys.
  bool failed() const { return failed_ || tooLong_; }
  bool tooLong() const { return tooLong_; }
  std::vector<RunningTween> endless() const;

  // Makes keys from now on; their times count from here.
  void record();
  // A tween is played, or a pose is set, at `time`, which does not decrease.
  void take(const ScriptEvent& event, double time);
  void advance(double until);
  // To where all have begun.
  void beginAll();
  // To the end of all that has one.
  void finish();
  // Call it once, after record().
  std::vector<MotionKey> keys();

 private:
  bool isDriven(bool ScriptEvent::*what) const;
  double changeOf(const RunningTween& tween) const;
  void resume(RunningTween& tween);
  void step(double to);
  void settle();
  Pose poseAt(double time, double middle) const;
  bool isEven() const;
  const RunningTween* oneLeg(double to, double middle) const;
  void sample(double to, double middle);
  void push(double time, const Pose& pose);

  Pose now_;
  double time_ = 0, zero_ = 0;
  std::vector<RunningTween> running_;  // at most one for the place and one for the turn
  std::vector<RunningTween> stopped_;  // by the script, the last one behind
  std::vector<MotionKey> keys_;
  int steps_ = 0;
  bool recording_ = false, failed_ = false, tooLong_ = false;
};

}  // namespace obby::importer
