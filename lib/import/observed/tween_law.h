// Extends motions past the end of the run, from the times and goals of tweens that outlast it.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "engine/observation.h"
#include "import/draft/draft.h"

namespace obby::importer {

class TweenLaws {
 public:
  // `origin` is the time of the first of the poses below, in seconds.
  explicit TweenLaws(const engine::Observation& seen, double origin = 0);

  // Returns the motion of a part whose tweens still play at the last of `poses`, one per frame.
  // Returns nullopt if there are none, if the part is not where they predict, or if they have no
  // common period.
  std::optional<Motion> outlasting(const std::vector<Pose>& poses, InstanceId part) const;

  // Returns the end time of the repeating tweens that play at the last frame. Returns nullopt if
  // there are none, or if they take more than twenty minutes. A tween that does not repeat belongs
  // to a loop of the script.
  std::optional<double> end(const std::vector<Pose>& poses, InstanceId part) const;

 private:
  std::vector<engine::Tween> tweens_;  // times count from the origin
  std::map<InstanceId, std::vector<const engine::Tween*>> byTarget_;
};

}  // namespace obby::importer
