// Parts whose script puts a player who touches them at a place that the text states.
#include <cmath>

#include "import/roles/role.h"

namespace obby::importer {
namespace {

constexpr float kRootAboveFeet = 3;  // studs; scripts move the root or the torso
constexpr float kFarthest = 1e6f;

Teleport teleportTo(const Pose& frame, bool turns) {
  const Vec3 back = frame.rotation.z;
  return {frame.position - Vec3{0, kRootAboveFeet, 0}, std::atan2(back.x, back.z), turns};
}

bool isPlace(Vec3 v) {
  return std::fabs(v.x) < kFarthest && std::fabs(v.y) < kFarthest && std::fabs(v.z) < kFarthest;
}

}  // namespace

void teleportFromScripts(RoleContext& context) {
  context.eachTouch([&](PartDraft& part, const Timeline& timeline, const ScriptReading& reading) {
    for (const ScriptEvent& event : timeline.events) {
      if (event.kind != EventKind::teleport || !event.frame || part.teleport || part.checkpoint)
        continue;
      Teleport to = teleportTo(*event.frame, event.property == "CFrame");
      if (!std::isfinite(to.yaw)) to = {to.position, 0, false};  // looks at what is not known
      if (!isPlace(to.position)) continue;
      part.teleport = to;
      part.evidence.push_back(
          {"teleport", scriptReason(context.tree, reading, event.line), event.unsure});
    }
  });
}

}  // namespace obby::importer
