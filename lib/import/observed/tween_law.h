// Tweens that play for longer than the run: their own times and goals tell what follows.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "engine/observation.h"
#include "import/draft.h"

namespace obby::importer {

class TweenLaws {
 public:
  // `origin`: the time of the first of the poses below, in seconds.
  explicit TweenLaws(const engine::Observation& seen, double origin = 0);

  // The motion of a part, at `poses` a frame each, whose tweens are not over at the last frame.
  // Nothing where there are none, where it is not where they would have it, or where they have no
  // common round.
  std::optional<Motion> outlasting(const std::vector<Pose>& poses, InstanceId part) const;

  // When the repeating tweens that play at the last frame end; nothing: there are none, or they
  // take more than twenty minutes. A tween of one way belongs to a loop of the script.
  std::optional<double> end(const std::vector<Pose>& poses, InstanceId part) const;

 private:
  std::vector<engine::Tween> tweens_;  // since the origin
  std::map<InstanceId, std::vector<const engine::Tween*>> byTarget_;
};

}  // namespace obby::importer
