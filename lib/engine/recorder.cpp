#include "engine/recorder.h"

#include <algorithm>
#include <utility>

namespace obby::engine {

void Recorder::place(InstanceId part, const Pose& before, const Pose& pose, Line line) {
  if (!recording_ || isFull()) return;
  Track& track = seen_.tracks[part];
  if (track.poses.empty()) {
    track.line = line;
    track.start = before;
  }
  if (const auto driver = drivers_.find(part); driver != drivers_.end())
    track.driver = driver->second;
  if (track.poses.empty() || track.poses.back().frame != frame_) {
    track.poses.push_back({frame_, pose});
    ++placed_;
  } else {
    track.poses.back().pose = pose;
  }
}

void Recorder::change(Change change) {
  if (!recording_ || isFull()) return;
  change.time = time();
  text_ += change.property.size();
  if (const auto* const text = std::get_if<std::string>(&change.value)) text_ += text->size();
  seen_.changes.push_back(std::move(change));
  ++changes_;
}

void Recorder::count(const std::string& what) {
  if (isFull()) return;
  const auto [row, isNew] = seen_.counts.try_emplace(what, 0);
  if (isNew) text_ += what.size();
  ++row->second;
}

void Recorder::problem(InstanceId script, Failure failure, std::string_view text) {
  text = shortened(text);
  for (Problem& known : seen_.problems)
    if (known.script == script && known.text == text) {
      ++known.count;
      known.failure = std::max(known.failure, failure);
      return;
    }
  if (seen_.problems.size() < kMaxProblems)
    seen_.problems.push_back({script, std::string(text), 1, failure});
}

void Recorder::restart() {
  const uint32_t frame = frame_;
  Observation kept;
  kept.random = seen_.random;
  kept.heeded = std::move(seen_.heeded);
  kept.happened = std::move(seen_.happened);
  seen_ = std::move(kept);
  changes_ = placed_ = text_ = 0;
  setTime(frame);
}

}  // namespace obby::engine
