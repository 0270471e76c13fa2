// The policy's observation does not depend on the order of parts, the heading of the level or the
// number of lanes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "support/level_builder.h"
#include "support/onlooker.h"

namespace obby::policy {
namespace {

using support::LevelBuilder;

struct Look : support::Onlooker {
  using Onlooker::Onlooker;

  std::vector<float> inputs(const sim::RigidBody* bodies = nullptr) const {
    return Onlooker::inputs(observe, bodies);
  }
  // Returns the present height of a map at a point of a ring, in studs above the feet.
  float height(Kind map, int ring, int direction) const {
    return kDeepest + shown(map, ring, direction);
  }
  // Returns the later height minus the present one.
  float change(Kind map, int ring, int direction) const {
    return shown(kKinds + map, ring, direction);
  }

 private:
  float shown(int map, int ring, int direction) const {
    return inputs()[size_t(kMapsAt + map * kPoints + 1 + ring * kDirections + direction)] * 8;
  }
};

// Returns a start, a gap of five studs, and then ground half a stud higher.
LevelBuilder gap() {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8});  // ends at z = -4
  b.block({0, 0, -13}, {8, 1, 8});    // from z = -9 to -17
  return b;
}

TEST(Observation, ShowsGroundAndGapsAtTheirHeights) {
  const level::Level level = gap().compile();
  const Look look(level);
  EXPECT_FLOAT_EQ(look.height(kFloor, 0, 0), 0) << "ahead, 1.5 studs";
  EXPECT_FLOAT_EQ(look.height(kFloor, 2, 0), kDeepest) << "ahead, 5.9 studs: the gap";
  EXPECT_FLOAT_EQ(look.height(kFloor, 4, 0), 0.5f) << "ahead, 13.1 studs: the other side";
  EXPECT_FLOAT_EQ(look.height(kFloor, 4, 6), kDeepest) << "behind";
  EXPECT_FLOAT_EQ(look.height(kDanger, 0, 0), kDeepest) << "no danger";
}

TEST(Observation, ShowsKillPartsAndRegionsToAvoid) {
  LevelBuilder b = gap();
  b.block({0, 1, -3.35f}, {4, 2, 0.5f}, [](schema::Part::Builder p) { p.initKill(); });
  const level::Level level = b.compile();
  Look look(level);
  EXPECT_FLOAT_EQ(look.height(kDanger, 1, 0), 2) << "ahead, 3.35 studs";
  EXPECT_FLOAT_EQ(look.height(kFloor, 1, 0), 0) << "nothing to stand on";
  level::TargetView avoid{{{{0, 2, -13.1f}, {}}, {1, 1, 1}}};
  look.query.avoid = &avoid;
  look.query.avoidCount = 1;
  EXPECT_FLOAT_EQ(look.height(kDanger, 4, 0), 3);
}

TEST(Observation, ShowsOnlyCeilingsThatAreInTheWay) {
  LevelBuilder b = gap();
  b.block({0, 9, 0}, {30, 1, 30});     // high above
  b.block({0, 3, -3.35f}, {4, 2, 1});  // a block at the height of the chest
  const level::Level level = b.compile();
  const Look look(level);
  EXPECT_FLOAT_EQ(look.height(kFloor, 0, 0), 0);
  EXPECT_FLOAT_EQ(look.height(kFloor, 1, 0), 4);
}

TEST(Observation, ShowsTheSlopeOfAWedge) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {3, 1, 3});
  b.part([](schema::Part::Builder p) {
    p.setShape(schema::Shape::WEDGE);
    support::set(p.initPosition(), {0, 2, -6});
    support::set(p.initSize(), {8, 4, 8});  // rises from 0 at z = -10 to 4 at z = -2
  });
  const level::Level level = b.compile();
  const Look look(level);
  EXPECT_NEAR(look.height(kFloor, 2, 0), 4 * (10 - 5.9f) / 8, 1e-4f);
  EXPECT_NEAR(look.height(kFloor, 1, 0), 4 * (10 - 3.35f) / 8, 1e-4f);
}

// Returns a start and a part of this shape and size. If `upright`, the part's x axis points up.
LevelBuilder round(schema::Shape shape, Vec3 center, Vec3 size, bool upright = false) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {3, 1, 3});
  b.part([=](schema::Part::Builder p) {
    p.setShape(shape);
    support::set(p.initPosition(), center);
    support::set(p.initSize(), size);
    if (upright) {
      p.initRotation().setW(std::sqrt(0.5f));
      p.getRotation().setZ(std::sqrt(0.5f));
    }
  });
  return b;
}

TEST(Observation, ShowsBallsAndCylindersAsTheyAre) {
  const auto height = [](LevelBuilder b, int ring, int direction) {
    const level::Level level = b.compile();
    return Look(level).height(kFloor, ring, direction);
  };
  const float aside = 5.85f / 2,
              along = 5.85f * std::sqrt(0.75f);  // the next direction of the ring
  const LevelBuilder ball = round(schema::Shape::BALL, {0, 4, -5.9f}, {8, 8, 8});
  EXPECT_NEAR(height(ball, 2, 0), 8, 1e-2f);
  const float far = std::hypot(aside, 5.9f - along);
  EXPECT_NEAR(height(ball, 2, 1), 4 + std::sqrt(16 - far * far), 0.05f);
  // The axis of this cylinder is x.
  const LevelBuilder log = round(schema::Shape::CYLINDER, {0, 3, -5.9f}, {16, 6, 6});
  EXPECT_NEAR(height(log, 2, 0), 6, 1e-2f);
  EXPECT_NEAR(height(log, 2, 1), 3 + std::sqrt(9 - (5.9f - along) * (5.9f - along)), 0.05f);
  const LevelBuilder post = round(schema::Shape::CYLINDER, {0, 2, -5.9f}, {4, 6, 6}, true);
  EXPECT_NEAR(height(post, 2, 0), 4, 1e-2f);
  EXPECT_FLOAT_EQ(height(post, 2, 1), kDeepest) << "a corner of the box around it";
}

TEST(Observation, ShowsDangersAsWideAsTheBodyTouchesThem) {
  LevelBuilder b = gap();
  b.block({1.4f, 1, -3.35f}, {1, 2, 1}, [](schema::Part::Builder p) { p.initKill(); });
  const level::Level level = b.compile();
  EXPECT_FLOAT_EQ(Look(level).height(kDanger, 1, 0), 2) << "0.9 studs next to it";
}

// Stones above lava are safe. A kill tile at the same height as its neighbours is not.
TEST(Observation, ShowsNoDangerBelowAFloor) {
  const auto kill = [](schema::Part::Builder p) { p.initKill(); };
  LevelBuilder b;
  b.block({0, -4, 0}, {60, 1, 60}, kill);
  b.block({0, -0.5f, 0}, {8, 1, 8});
  b.block({0, -0.5f, -13.1f}, {4, 1, 4}, kill);
  const level::Level level = b.compile();
  const Look look(level);
  EXPECT_FLOAT_EQ(look.height(kDanger, 0, 0), kDeepest) << "under the stone";
  EXPECT_FLOAT_EQ(look.height(kDanger, 2, 0), -3.5f) << "next to it";
  EXPECT_FLOAT_EQ(look.height(kDanger, 4, 0), 0) << "the tile";
}

TEST(Observation, ShowsTheNearestDynamicBody) {
  LevelBuilder b = gap();
  for (const float x : {-9.0f, 4.0f})
    b.block({x, 1, 0}, {2, 2, 2}, [](schema::Part::Builder p) { p.setAnchored(false); });
  const level::Level level = b.compile();
  std::vector<sim::RigidBody> bodies = sim::makeBodies(level.view());
  ASSERT_EQ(bodies.size(), 2u);
  bodies[1].velocity = {0, 0, -8};
  const Look look(level);
  const std::vector<float> in = look.inputs(bodies.data());
  const float* const at = in.data() + kStateInputs;
  EXPECT_EQ(at[0], 1);
  EXPECT_NEAR(at[1], 0, 1e-5f);
  EXPECT_NEAR(at[2], 4.0f / (4 + 8), 1e-5f) << "to the right";
  EXPECT_NEAR(at[4], 0.5f, 1e-5f) << "it moves ahead";
}

void setRate(LevelBuilder& b, int rate) {
  b.physics([rate](schema::PhysicsParams::Builder p) {
    p.setControlRate(uint16_t(rate));
    p.setSubsteps(uint16_t(240 / rate));
  });
}

class SeesMovers : public testing::TestWithParam<int> {};  // the parameter is in ticks per second

TEST_P(SeesMovers, ShowsPresentAndFutureHeights) {
  LevelBuilder b = gap();
  setRate(b, GetParam());
  b.block({0, 0.5f, -5.9f}, {4, 1, 1}, [](schema::Part::Builder p) {
    auto keys = p.initMotion().initKeys(2);
    support::set(keys[0].initPosition(), {0, 0.5f, -5.9f});
    support::set(keys[1].initPosition(), {0, 4.5f, -5.9f});
    keys[1].setTime(1);
  });
  const level::Level level = b.compile();
  const Look look(level);
  EXPECT_NEAR(look.height(kFloor, 2, 0), 1, 1e-3f);
  EXPECT_NEAR(look.change(kFloor, 2, 0), 4 * 0.4f, 0.05f);
  EXPECT_FLOAT_EQ(look.change(kFloor, 0, 0), 0) << "the start stays";
}

INSTANTIATE_TEST_SUITE_P(Observation, SeesMovers, testing::Values(30, 60, 240));

// Observes the same moment of a level with longer and shorter ticks.
TEST(Observation, IsInSecondsForAnyTickLength) {
  std::vector<float> expected;
  for (const int rate : {60, 30, 120, 240}) {
    LevelBuilder b = gap();
    setRate(b, rate);
    const level::Level level = b.compile();
    Look look(level);
    const uint32_t tenth = uint32_t(rate) / 10;
    look.world.floorlessSteps = uint16_t(2 * tenth * level.view().params.substeps);
    look.world.tick = 5 * tenth;
    look.query.timeLimitTicks = 40 * tenth;
    const std::vector<float> seen = look.inputs();
    if (expected.empty()) expected = seen;
    for (size_t i = 0; i < seen.size(); ++i)
      EXPECT_FLOAT_EQ(seen[i], expected[i]) << i << " at " << rate;
  }
  EXPECT_FLOAT_EQ(expected[4], 12 * 0.0333f) << "0.2 s without a floor";
}

TEST(Observation, DoesNotDependOnTheOrderOfParts) {
  LevelBuilder forth, back;
  const auto part = [](LevelBuilder& b, int i) {
    const float at = float(i);
    b.block({3 * at - 12, at * 0.3f, -2 * at}, {5, 1, 4}, [i](schema::Part::Builder p) {
      support::setRotation(p.initRotation(), float(i), 0.2f * float(i % 3));
      if (i % 4 == 0) p.initKill();
    });
  };
  for (int i = 0; i < 9; ++i) {
    part(forth, i);
    part(back, 8 - i);
  }
  const level::Level one = forth.compile(), two = back.compile();
  EXPECT_EQ(Look(one).inputs(), Look(two).inputs());
}

TEST(Observation, TurnsWithTheLevel) {
  const auto quarter = [](Vec3 v) { return Vec3{v.z, v.y, -v.x}; };
  LevelBuilder plain, turned;
  const Vec3 centers[] = {{0, -0.5f, 0}, {3, 0, -8}, {-2, 1, -12}};
  for (const Vec3 c : centers) {
    plain.block(c, {6.1f, 1, 4.1f});
    turned.block(quarter(c), {4.1f, 1, 6.1f});
  }
  const level::Level one = plain.compile(), two = turned.compile();
  const Look a(one, {0, 0, -30});
  Look b(two, quarter({0, 0, -30}));
  b.world.yaw = Turns(b.world.yaw + headingOf(-30, 0));
  const std::vector<float> x = a.inputs(), y = b.inputs();
  for (size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 2e-4f) << i;
}

TEST(Observation, IsBitIdenticalInOneLaneAndInMany) {
  const level::Level level = support::boxArena(100, 3).compile();
  Look look(level);
  Random random(1, 1);
  for (int n = 0; n < 200; ++n) {
    look.world.position = {40 * random.unit() - 20, 8 * random.unit(), 40 * random.unit() - 20};
    look.world.velocity = {random.unit(), random.unit(), random.unit()};
    look.world.yaw = Turns(random.next());
    std::vector<float> wide(kInputs), narrow(kInputs);
    const Turns a = observe(look.scene, look.world, nullptr, wide.data());
    const Turns b = observe<float>(look.scene, look.world, nullptr, narrow.data());
    EXPECT_EQ(a, b);
    EXPECT_EQ(std::memcmp(wide.data(), narrow.data(), kInputs * sizeof(float)), 0);
  }
}

TEST(Observation, EqualsThePartByPartObservationBitForBit) {
  const level::Level levels[] = {support::boxArena(100, 3).compile(),
                                 support::movingArena(60, 14, 2).compile()};
  Random random(2, 2);
  int seen = 0;
  for (const level::Level& level : levels) {
    Look look(level);
    for (int n = 0; n < 100; ++n) {
      look.world.position = {40 * random.unit() - 20, 8 * random.unit(), 40 * random.unit() - 20};
      look.world.yaw = Turns(random.next());
      look.world.tick = random.below(1000);
      std::vector<float> parts(kInputs, -1);
      const sim::NextRegion next = sim::nextRegion(look.scene.query, look.world);
      const Turns ahead = aheadOf(*next.region, look.world);
      for (int part = 0; part < kViewParts; ++part)
        observePart(look.scene, look.world, nullptr, next, ahead, part, parts.data());
      const std::vector<float> whole = look.inputs();
      EXPECT_EQ(std::memcmp(whole.data(), parts.data(), kInputs * sizeof(float)), 0);
      seen += int(std::count_if(whole.begin() + kMapsAt, whole.end(),
                                [](float h) { return h != kEmptyInput; }));
    }
  }
  EXPECT_GT(seen, 1000) << "something was in sight";
}

}  // namespace
}  // namespace obby::policy
