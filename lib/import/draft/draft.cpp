#include "import/draft/draft.h"

#include "import/document/pose_math.h"

#include "import/document/tree.h"

namespace obby::importer {

bool MotionKey::operator==(const MotionKey& other) const {
  return time == other.time && isSame(pose, other.pose) && easing == other.easing &&
         direction == other.direction;
}

void LevelDraft::noteUnmodelled(const std::string& kind, const Tree& tree, InstanceId at,
                                const std::string& note) {
  const bool known = at < tree.size();
  count(unmodelled, kind, known ? tree.path(at) : "", note);
  losses.insert({known ? at : kNoInstance, kind});
}

}  // namespace obby::importer
