// Records what happens in the world while scripts run. Private to lib/engine.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "engine/observation.h"

namespace obby::engine {

class Recorder {
 public:
  // Starts recording.
  void begin() { recording_ = true; }
  bool isRecording() const { return recording_; }
  void setTime(uint32_t frame) { frame_ = frame, seen_.frames = frame; }
  double time() const { return frame_ / 60.0; }

  // Returns true if the line that moves this part is not recorded yet.
  bool isUnmoved(InstanceId part) const { return !seen_.tracks.contains(part); }
  void place(InstanceId part, const Pose& before, const Pose& pose, Line line);
  // Records that a constraint or mover moves the part from now on.
  void drive(InstanceId part, InstanceId driver) { drivers_[part] = driver; }
  void change(Change change);
  void tween(Tween tween) { seen_.tweens.push_back(std::move(tween)); }
  void harm(double from, double to, Line line, bool stoppable) {
    seen_.harms.push_back({time(), from, to, line, stoppable});
  }
  void problem(InstanceId script, Failure failure, std::string_view text);
  void count(const std::string& what);
  void heed(const std::string& what, InstanceId target, Line line) {
    seen_.heeded[what].push_back({target, line});
  }
  void happen(const std::string& what) { seen_.happened[what] = true; }
  // Records that a script draws a number that differs between games.
  void noteDraw() { seen_.random = true; }
  // Returns the part of a problem's text that is kept.
  static std::string_view shortened(std::string_view text) {
    return text.substr(0, kMaxProblemText);
  }
  // Returns a count that increases with everything recorded.
  size_t activity() const { return changes_ + placed_ + seen_.harms.size() + seen_.tweens.size(); }
  // Returns true if the recorder's budget is used up.
  bool isFull() const {
    return changes_ >= kMaxChanges || placed_ >= kMaxPlaced || text_ >= kMaxText;
  }

  Observation& seen() { return seen_; }
  const Observation& seen() const { return seen_; }
  // Forgets what was seen so far, so that a probe reports only its own events.
  void restart();

 private:
  static constexpr size_t kMaxChanges = 300'000, kMaxPlaced = 4'000'000;
  static constexpr size_t kMaxText = size_t(64) << 20;  // bytes
  // Max number of problems, and max bytes of the text of each. The rest is dropped.
  static constexpr size_t kMaxProblems = 500, kMaxProblemText = 1000;

  Observation seen_;
  std::map<InstanceId, InstanceId> drivers_;  // drivers by part
  bool recording_ = false;
  uint32_t frame_ = 0;
  size_t changes_ = 0, placed_ = 0, text_ = 0;
};

}  // namespace obby::engine
