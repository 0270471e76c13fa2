// Blocks whose axes are swapped so that they stand upright keep their shape. Other shapes are left
// alone.
#include "level/upright.h"

#include <gtest/gtest.h>

#include "geom/shapes/block.h"
#include "support/level_builder.h"

namespace obby::level {
namespace {

using support::LevelBuilder;

// Returns the extent of the collider's block from its centre, in a world direction.
float extent(const Collider& c, Vec3 direction) {
  return geom::Block::support(c.shape, toLocal(c.pose.rotation, direction));
}

Collider blockOf(const Mat3& axes, Vec3 half) {
  Collider c{};
  c.pose = {{1, 2, 3}, axes};
  c.shape.half = half;
  return c;
}

Mat3 yawed(Turns yaw) {
  const SinCos a = sinCos(yaw);
  return {{a.cos, 0, -a.sin}, {0, 1, 0}, {a.sin, 0, a.cos}};
}

// Returns the 24 axis-aligned orientations.
std::vector<Mat3> sides() {
  std::vector<Mat3> out;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const Vec3 x = geom::unitAxis(i / 2) * (i % 2 ? -1.f : 1.f);
      const Vec3 y = geom::unitAxis(j / 2) * (j % 2 ? -1.f : 1.f);
      if (i / 2 != j / 2) out.push_back({x, y, cross(x, y)});
    }
  }
  return out;
}

TEST(MakeUpright, KeepsTheBlockInAllAxisAlignedOrientations) {
  Random random(7, 7);
  const auto number = [&] { return 2 * random.unit() - 1; };
  ASSERT_EQ(sides().size(), 24u);
  for (const Mat3& side : sides()) {
    for (int round = 0; round < 50; ++round) {
      const Collider before = blockOf(yawed(Turns(random.next())) * side, {0.5f, 1.25f, 3});
      Collider after = before;
      ASSERT_TRUE(makeUpright(after));
      const Mat3& r = after.pose.rotation;
      EXPECT_TRUE(r.y == (Vec3{0, 1, 0}));
      EXPECT_GT(dot(cross(r.x, r.y), r.z), 0.999f) << "right-handed";
      EXPECT_TRUE(after.pose.position == before.pose.position);
      for (int k = 0; k < 20; ++k) {
        const Vec3 d = normalize(Vec3{number(), number(), number()});
        ASSERT_NEAR(extent(after, d), extent(before, d), 1e-5f);
      }
    }
  }
}

TEST(MakeUpright, LeavesTiltedBlocksUnchanged) {
  for (const float pitch : {0.001f, 0.4f, 1.2f}) {
    const SinCos a = sinCos(turnsFromRadians(pitch));
    const Mat3 tilt{{1, 0, 0}, {0, a.cos, a.sin}, {0, -a.sin, a.cos}};
    for (const Mat3& side : sides()) {
      const Collider before = blockOf(tilt * side, {0.5f, 1.25f, 3});
      Collider after = before;
      EXPECT_FALSE(makeUpright(after));
      EXPECT_TRUE(after.pose.rotation.x == before.pose.rotation.x);
      EXPECT_TRUE(after.shape.half == before.shape.half);
    }
  }
}

TEST(UprightFlag, IsSetForBlocksThatStandOnAFace) {
  LevelBuilder b;
  b.block({0, 0, 0}, {1, 2, 3}, [](auto p) { support::setRotation(p.initRotation(), 0.3f); });
  b.block({0, 9, 0}, {1, 2, 3}, [](auto p) { support::setRotation(p.initRotation(), 0, kPi / 2); });
  b.block({9, 0, 0}, {1, 2, 3}, [](auto p) { support::setRotation(p.initRotation(), 0, 0.5f); });
  const Level level = b.compile();
  EXPECT_TRUE(level.view().bounds[0].flags & kUpright);
  EXPECT_TRUE(level.view().bounds[1].flags & kUpright);
  EXPECT_FALSE(level.view().bounds[2].flags & kUpright);
}

// The flag selects the fast path for blocks in floor rays and contacts.
TEST(UprightFlag, IsNeverSetForOtherShapesMovingOrNot) {
  for (const auto shape : {schema::Shape::BALL, schema::Shape::CYLINDER, schema::Shape::WEDGE,
                           schema::Shape::CORNER_WEDGE, schema::Shape::HULL}) {
    for (const bool moving : {false, true}) {
      LevelBuilder b;
      b.block({0, 0, 0}, {2, 2, 2}, [=](schema::Part::Builder p) {
        p.setShape(shape);
        if (shape == schema::Shape::HULL) {
          auto v = p.initHulls(1)[0].initVertices(4);
          for (uint32_t i = 1; i < 4; ++i) support::set(v[i], geom::unitAxis(int(i) - 1));
        }
        if (moving) p.initMotion().initSpin().setSpeed(1);
      });
      const Level level = b.compile();
      ASSERT_EQ(level.view().colliderCount, 1u);
      EXPECT_FALSE(level.view().bounds[0].flags & kUpright) << int(shape) << moving;
    }
  }
}

TEST(UprightFlag, IsSetForMovingBlocksThatStayUpright) {
  const auto flagsOf = [](Vec3 axis) {
    LevelBuilder b;
    b.block({0, 0, 0}, {2, 1, 3}, [=](auto p) {
      auto spin = p.initMotion().initSpin();
      spin.setSpeed(1);
      support::set(spin.initAxis(), axis);
    });
    return b.compile().view().bounds[0].flags;
  };
  EXPECT_TRUE(flagsOf({0, 1, 0}) & kUpright);
  EXPECT_FALSE(flagsOf({1, 0, 0}) & kUpright);
}

}  // namespace
}  // namespace obby::level
