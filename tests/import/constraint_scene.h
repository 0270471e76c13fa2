// Parts on constraints, for the tests of motion by physics.
#pragma once

#include "import/scene.h"

namespace obby::test {

// An arm below an anchored base. The constraint's axis points up.
struct Constraint {
  InstanceId id, base, arm;
};
inline Constraint constrained(Scene& scene, const char* className) {
  Constraint c{};
  c.base = scene.part("Base", {0, 10, 0});
  c.arm = scene.part("Arm", {0, 8, 0});
  scene.set(c.arm, "Anchored", false);
  const auto a0 = scene.add("Attachment", "A0", c.base), a1 = scene.add("Attachment", "A1", c.arm);
  const Mat3 axisUp = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  scene.set(a0, "CFrame", CFrame{{0, -2, 0}, axisUp});
  scene.set(a1, "CFrame", CFrame{{}, axisUp});
  c.id = scene.add(className, className, c.base);
  scene.set(c.id, "Attachment0", Ref{a0});
  scene.set(c.id, "Attachment1", Ref{a1});
  return c;
}

// Returns a slider whose motor pushes the arm up at 5 studs/s.
inline Constraint pushed(Scene& scene, const char* className) {
  const auto c = constrained(scene, className);
  scene.set(c.id, "ActuatorType", EnumItem{1, {}});
  scene.set(c.id, "Velocity", 5.0);
  scene.set(c.id, "MotorMaxForce", 1e6);
  return c;
}

// Returns a slider whose servo takes the arm to its target at 10 studs/s.
inline Constraint servoed(Scene& scene) {
  const auto c = constrained(scene, "PrismaticConstraint");
  scene.set(c.id, "ActuatorType", EnumItem{2, {}});
  scene.set(c.id, "Speed", 10.0);
  scene.set(c.id, "ServoMaxForce", 1e6);
  return c;
}

// An arm that any class of joint attaches to an anchored hub ten studs away. The joint is named
// "Weld".
struct Joined {
  InstanceId hub, arm;
};
inline Joined joined(Scene& scene, const char* className) {
  const Joined j{scene.part("Hub"), scene.part("Arm", {10, 0, 0})};
  scene.set(j.arm, "Anchored", false);
  const auto joint = scene.add(className, "Weld", j.hub);
  scene.set(joint, "Part0", Ref{j.hub});
  scene.set(joint, "Part1", Ref{j.arm});
  return j;
}

}  // namespace obby::test
