// Calibrated parameters, and parameters that a level itself states.
#include "io/physics.h"

#include <gtest/gtest.h>

namespace obby::io {
namespace {

Record params(float gravity, float walkSpeed) {
  RecordBuilder out;
  auto p = out.root().initParams();
  p.setGravity(gravity);
  p.setWalkSpeed(walkSpeed);
  return Record(std::move(out));
}

Record physicsLevel(float walkSpeed) {
  RecordBuilder out;
  auto l = out.root().initLevel();
  l.setName("tower");
  l.initParts(1)[0].setName("Lava");
  l.initPhysics().setWalkSpeed(walkSpeed);
  return Record(std::move(out));
}

TEST(Physics, FillsFieldsThatTheLevelLeavesAtTheirDefaults) {
  Physics physics;
  physics.know(params(190, 15.5f));
  const Record calibrated = physics.applied(physicsLevel(16));
  const auto l = calibrated.reader().getLevel();
  EXPECT_EQ(l.getPhysics().getGravity(), 190);
  EXPECT_EQ(l.getPhysics().getWalkSpeed(), 15.5f);
  EXPECT_EQ(l.getPhysics().getJumpSpeed(), 53);
  EXPECT_EQ(l.getName(), "tower");
  EXPECT_EQ(l.getParts()[0].getName(), "Lava");
}

TEST(Physics, KeepsFieldsThatTheLevelStates) {
  Physics physics;
  physics.know(params(190, 15.5f));
  const Record once = physics.applied(physicsLevel(24)), twice = physics.applied(once);
  for (const Record* r : {&once, &twice}) {
    EXPECT_EQ(r->reader().getLevel().getPhysics().getGravity(), 190);
    EXPECT_EQ(r->reader().getLevel().getPhysics().getWalkSpeed(), 24);
  }
}

TEST(Physics, TheLastRecordCounts) {
  Physics physics;
  EXPECT_FALSE(physics.known());
  physics.know(params(190, 16));
  physics.know(params(150, 16));
  EXPECT_EQ(physics.applied(physicsLevel(16)).reader().getLevel().getPhysics().getGravity(), 150);
}

}  // namespace
}  // namespace obby::io
