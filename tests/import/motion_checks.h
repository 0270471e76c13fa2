// Positions of a moving part, for the tests of motions.
#pragma once

#include <algorithm>
#include <cmath>

#include "import/document/pose_math.h"
#include "import/scene.h"

namespace obby::test {

// A part `p` with a script on it.
struct ScriptedPart : Scene {
  explicit ScriptedPart(const std::string& text) {
    script("local p = script.Parent\n" + text, self);
    level();
  }
  const InstanceId self = part("Pad");
};

inline void expectNear(Vec3 a, Vec3 b, float slack = 0.02f) {
  EXPECT_NEAR(a.x, b.x, slack);
  EXPECT_NEAR(a.y, b.y, slack);
  EXPECT_NEAR(a.z, b.z, slack);
}

// Returns the part's position `time` seconds after its first key, by linear interpolation.
inline Vec3 at(const PartDraft& part, float time) {
  const auto& keys = part.motion->keys;
  for (size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].time < time) continue;
    const float span = keys[i].time - keys[i - 1].time;
    const float t = span > 0 ? (time - keys[i - 1].time) / span : 1;
    return keys[i - 1].pose.position + (keys[i].pose.position - keys[i - 1].pose.position) * t;
  }
  return keys.back().pose.position;
}

// Returns the part's pose `time` seconds after the start of play, as in the simulator.
inline Pose poseAt(const PartDraft& part, double time) {
  if (!part.motion) return part.pose;
  const importer::Motion& motion = *part.motion;
  const auto& keys = motion.keys;
  double now = double(motion.offset) + time;
  Pose pose = part.pose;
  if (!keys.empty()) {
    const double length = double(keys.back().time);
    double within = std::max(now, 0.0);
    if (motion.repeat == importer::Repeat::loop && length > 0)
      within = std::fmod(std::fmod(now, length) + length, length);
    size_t next = 0;
    while (next < keys.size() && double(keys[next].time) <= within) ++next;
    pose = keys[next == keys.size() ? next - 1 : next].pose;
    if (next > 0 && next < keys.size()) {
      const auto &from = keys[next - 1], &to = keys[next];
      const double share = (within - double(from.time)) / double(to.time - from.time);
      pose = importer::between(from.pose, to.pose, float(share));
    }
  }
  if (!motion.spin) return pose;
  const Mat3 turn = rotationAbout(motion.spin->axis, double(motion.spin->speed) * now);
  const Vec3 pivot = motion.spin->pivot;
  return pose * Pose{pivot - turn * pivot, turn};
}

// Returns degrees about Y, from -180 to 180.
inline float yawAt(const PartDraft& part, double time) {
  const Vec3 ahead = poseAt(part, time).rotation.z;
  return std::atan2(ahead.x, ahead.z) * 57.29578f;
}

}  // namespace obby::test
