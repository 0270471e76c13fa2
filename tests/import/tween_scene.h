// One part that scripts tween, for the tests of tweens.
#pragma once

#include <initializer_list>
#include <string>

#include "import/motion_checks.h"

namespace obby::test {

// Defines `ts`, the part `p`, and tween(info, goals) for it.
inline const std::string kBefore = R"(local ts, p = game:GetService("TweenService"), workspace.Mover
local function tween(info, goals) return ts:Create(p, info, goals) end
local line, way = Enum.EasingStyle.Linear, Enum.EasingDirection.In
local function even(seconds) return TweenInfo.new(seconds, line, way) end
local function ever(seconds) return TweenInfo.new(seconds, line, way, -1) end
local function swing(seconds) return TweenInfo.new(seconds, line, way, -1, true) end
local function to(z) return {Position = Vector3.new(0, 0, z)} end
)";

// One part that the scripts tween, each with kBefore.
struct Overlap {
  explicit Overlap(std::initializer_list<std::string> texts) {
    part = scene.part("Mover");
    for (const std::string& text : texts) scene.script(kBefore + text, scene.scripts);
    scene.level();
  }
  const importer::Motion& motion() const {
    static const importer::Motion kNone;
    EXPECT_TRUE(scene[part].motion);
    return scene[part].motion ? *scene[part].motion : kNone;
  }
  Vec3 at(double time) const { return poseAt(scene[part], time).position; }
  float z(double time) const { return at(time).z; }
  float yaw(double time) const { return yawAt(scene[part], time); }

  Scene scene;
  InstanceId part = kNoInstance;
};

}  // namespace obby::test
