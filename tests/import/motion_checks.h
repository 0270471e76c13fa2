// Where a moving part is, for the tests of motions.
#pragma once

#include "import/scene.h"

namespace obby::test {

// A part, and a script on it that calls it `p`.
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

// Where the part is `time` seconds after the start of its keys, on straight ways.
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

}  // namespace obby::test
