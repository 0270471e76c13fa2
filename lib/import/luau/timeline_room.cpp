#include "import/luau/timeline_room.h"

namespace obby::importer::luau {

bool TimelineRoom::take() {
  if (left_ > 0) {
    --left_;
    return true;
  }
  full_ = true;
  return false;
}

ScriptEvent& TimelineRoom::addTo(std::vector<ScriptEvent>& events) {
  return take() ? events.emplace_back() : lost_.emplace();
}

}  // namespace obby::importer::luau
