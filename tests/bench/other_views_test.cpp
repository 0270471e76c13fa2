// The alternative observations show parts at their places, whatever the order of parts in the
// level.
#include "views/other_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/shapes/table.h"
#include "support/level_builder.h"
#include "support/onlooker.h"

namespace obby::bench {
namespace {

using policy::kDanger, policy::kFloor;
using support::LevelBuilder, support::Onlooker;

constexpr int kLevelRay = 3;  // index of the horizontal ray
constexpr int kNow = 0, kSoon = 1, kAhead = 0, kLeft = 3, kBehind = 6;

float closeness(float distance) { return 1 - distance / kRayReach; }

// The inputs of the observation `rays`.
struct Ray {
  std::vector<float> inputs;
  float operator()(int moment, policy::Kind kind, int ray) const {
    return inputs[size_t(rayInput(moment, kind, ray))];
  }
};

// The inputs of an observation that lists parts.
struct List {
  std::vector<float> inputs;
  float operator()(int place, PartNumber number, int axis = 0) const {
    return inputs[size_t(partInput(place, number) + axis)];
  }
  int count() const {
    int n = 0;
    while (n < kListedParts && (*this)(n, kPartThere) != 0) ++n;
    return n;
  }
};

Ray raysOf(LevelBuilder b) {
  const level::Level level = b.compile();
  return {Onlooker(level).inputs(rays)};
}

List listOf(LevelBuilder b) {
  const level::Level level = b.compile();
  return {Onlooker(level).inputs(nearestParts)};
}

void kills(schema::Part::Builder p) { p.initKill(); }

LevelBuilder start() {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8});
  return b;
}

TEST(Rays, MeetFloorsBelowAndWallsAhead) {
  LevelBuilder b = start();
  b.block({0, 3, -6.5f}, {4, 6, 1});
  const Ray ray = raysOf(b);
  EXPECT_NEAR(ray(kNow, kFloor, 0), closeness(3), 1e-5f) << "straight down";
  const float degrees = 63;
  EXPECT_NEAR(ray(kNow, kFloor, rayAt(0, kBehind)), closeness(3 / std::sin(degrees * kPi / 180)),
              1e-4f);
  EXPECT_NEAR(ray(kNow, kFloor, rayAt(kLevelRay, kAhead)), closeness(6), 1e-5f);
  EXPECT_EQ(ray(kNow, kFloor, rayAt(kLevelRay, kBehind)), 0);
  EXPECT_EQ(ray(kNow, kFloor, rayAt(1, kBehind)), 0) << "4.3 studs behind, beyond the start";
  for (int r = 0; r < kRays; ++r) {
    EXPECT_EQ(ray(kNow, kDanger, r), 0) << r;
    EXPECT_EQ(ray(kSoon, kFloor, r), 0) << r;
  }
}

TEST(Rays, ShowDangersAsWideAsInTheMapsExceptBehindFloors) {
  LevelBuilder b = start();
  b.block({-5.5f, 3, 0}, {1, 6, 4}, kills);
  b.block({0, 3, -6.5f}, {4, 6, 1});
  b.block({0, 3, -10}, {4, 6, 1}, kills);
  const Ray ray = raysOf(b);
  EXPECT_NEAR(ray(kNow, kDanger, rayAt(kLevelRay, kLeft)), closeness(4), 1e-5f) << "a stud wider";
  EXPECT_EQ(ray(kNow, kFloor, rayAt(kLevelRay, kLeft)), 0);
  EXPECT_EQ(ray(kNow, kDanger, rayAt(kLevelRay, kAhead)), 0);
  EXPECT_NEAR(ray(kNow, kFloor, rayAt(kLevelRay, kAhead)), closeness(6), 1e-5f);
}

// Returns a wall whose face is 7.5 studs away and approaches at four studs/s.
LevelBuilder coming(bool isDanger) {
  LevelBuilder b = start();
  b.block({0, 3, -8}, {4, 6, 1}, [=](schema::Part::Builder p) {
    auto keys = p.initMotion().initKeys(2);
    support::set(keys[0].initPosition(), {0, 3, -8});
    support::set(keys[1].initPosition(), {0, 3, -4});
    keys[1].setTime(1);
    if (isDanger) p.initKill();
  });
  return b;
}

TEST(Rays, IncludeTheChangeFromMovingParts) {
  const int ahead = rayAt(kLevelRay, kAhead);
  const Ray floor = raysOf(coming(false)), danger = raysOf(coming(true));
  EXPECT_NEAR(floor(kNow, kFloor, ahead), closeness(7.5f), 1e-3f);
  EXPECT_NEAR(floor(kSoon, kFloor, ahead), 4 * 0.4f / kRayReach, 5e-3f);
  EXPECT_EQ(floor(kSoon, kFloor, 0), 0) << "the start stays";
  EXPECT_NEAR(danger(kNow, kDanger, ahead), closeness(6.5f), 1e-3f);
  EXPECT_NEAR(danger(kSoon, kDanger, ahead), 4 * 0.4f / kRayReach, 5e-3f);
}

// Returns a part of this shape near the eye, with random place and rotation.
LevelBuilder somewhere(schema::Shape shape, Random& random) {
  const auto uniform = [&random](float lo, float hi) { return lo + (hi - lo) * random.unit(); };
  const Vec3 center{uniform(-6, 6), uniform(-4, 7), uniform(-6, 6)};
  const Vec3 size{uniform(2, 6), uniform(2, 6), uniform(2, 6)};
  const float yaw = uniform(0, 6), pitch = uniform(-1, 1);
  LevelBuilder b;
  b.block(center, size, [=](schema::Part::Builder p) {
    p.setShape(shape);
    support::setRotation(p.initRotation(), yaw, pitch);
  });
  return b;
}

// Returns the closeness that ray() should return, computed from the simulator's shapes.
float castRay(const level::Collider& c, int elevation, int direction) {
  const Vec3 eye{0, kEyeHeight, 0}, flat = policy::rosetteDirection(0, direction);
  const float up = kRayDegrees[elevation] * kPi / 180;
  const Vec3 ray = flat * std::cos(up) + Vec3{0, std::sin(up), 0};
  const Vec3 o = toLocal(c.pose, eye), d = toLocal(c.pose.rotation, ray);
  geom::RayHit hit{};
  const bool met = geom::visitShape(
      c.kind, [&](auto shape) { return shape.castRay(c.shape, o, d, kRayReach, hit); });
  return met ? closeness(hit.t) : 0;
}

// Rays that graze an edge may give different results.
TEST(Rays, MeetShapesLikeTheSimulatorsRays) {
  Random random(11, 0);
  for (const auto shape :
       {schema::Shape::BLOCK, schema::Shape::BALL, schema::Shape::CYLINDER, schema::Shape::WEDGE}) {
    int met = 0, wrong = 0;
    for (int n = 0; n < 400; ++n) {
      const level::Level level = somewhere(shape, random).compile();
      const Ray ray{Onlooker(level).inputs(rays)};
      for (int r = 1; r < kRays; ++r) {
        const float seen = ray(kNow, kFloor, r);
        if (seen == 1) continue;  // the eye is inside the part
        const int elevation = (r - 1) / policy::kDirections;
        const float expected =
            castRay(level.view().colliders[0], elevation, (r - 1) % policy::kDirections);
        met += expected > 0;
        wrong += std::abs(seen - expected) > 1e-3f;
      }
    }
    EXPECT_GT(met, 100) << int(shape);
    EXPECT_LE(wrong, met / 100) << int(shape);
  }
}

float feature(float studs, float half) { return policy::squashed(studs, half); }

TEST(NearestParts, AreListedInThePlayersFrameNearestFirst) {
  LevelBuilder b;
  b.block({0, 2.5f, -9}, {4, 4, 2}, kills);  // ahead; the near face is 8 studs away
  b.block({6, 4.5f, 0}, {2, 2, 2});          // to the right and up, 5.1 studs away
  b.block({0, -0.5f, 0}, {8, 1, 8});         // 2.5 studs below the body's middle
  const List list = listOf(b);
  ASSERT_EQ(list.count(), 3);
  const bool danger[] = {false, false, true};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(list(i, kPartIsFloor), danger[i] ? 0 : 1) << i;
    EXPECT_EQ(list(i, kPartIsDanger), danger[i] ? 1 : 0) << i;
    EXPECT_EQ(list(i, kPartThere), kStays) << i;
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(list(i, kPartMoved, axis), 0) << i;
  }
  EXPECT_NEAR(list(0, kPartNearest, 2), feature(-2.5f, kNearPart), 1e-5f) << "below";
  EXPECT_NEAR(list(0, kPartHalf, 2), feature(0.5f, kLargePart), 1e-5f);
  EXPECT_NEAR(list(1, kPartCenter, 1), feature(6, kFarPart), 1e-5f) << "to the right";
  EXPECT_NEAR(list(1, kPartCenter, 2), feature(2, kFarPart), 1e-5f) << "up";
  EXPECT_NEAR(list(1, kPartNearest, 1), feature(5, kNearPart), 1e-5f);
  EXPECT_NEAR(list(2, kPartCenter, 0), feature(9, kFarPart), 1e-5f) << "ahead";
  EXPECT_NEAR(list(2, kPartHalf, 0), feature(1, kLargePart), 1e-5f);
  EXPECT_NEAR(list(2, kPartHalf, 1), feature(2, kLargePart), 1e-5f);
  EXPECT_NEAR(list(2, kPartNearest, 0), feature(8, kNearPart), 1e-5f);
}

TEST(NearestParts, IncludeTheirFutureMotion) {
  const List list = listOf(coming(true));
  ASSERT_EQ(list.count(), 2) << "what moves is listed once";
  EXPECT_NEAR(list(1, kPartMoved, 0), feature(-4 * 0.4f, kFastPart), 2e-2f);
  EXPECT_EQ(list(1, kPartThere), kStays);
  EXPECT_EQ(list(0, kPartMoved, 0), 0);
}

// Two tiles of the same size take turns: when one vanishes, the other appears.
TEST(NearestParts, TellVanishingPartsFromAppearingOnes) {
  LevelBuilder b = start();
  for (const bool comes : {false, true}) {
    b.block({0, -0.5f, comes ? -12.0f : -6.0f}, {4, 1, 4}, [=](schema::Part::Builder p) {
      auto vanish = p.initVanish();
      vanish.setTrigger(schema::VanishTrigger::TIMER);
      vanish.setDelay(0.2f);
      vanish.setAway(0.8f);
      vanish.setInverted(comes);
    });
  }
  const List list = listOf(b);
  ASSERT_EQ(list.count(), 3);
  EXPECT_EQ(list(1, kPartThere), kGoes);
  EXPECT_EQ(list(2, kPartThere), kComes);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(list(i, kPartMoved, 0), 0) << i;
}

// Returns a level of random parts, in the order of their numbers or in reverse.
level::Level scattered(int parts, bool backwards) {
  LevelBuilder b;
  for (int i = 0; i < parts; ++i) {
    const int number = backwards ? parts - 1 - i : i;
    Random random(5, uint64_t(number));
    const auto uniform = [&random](float lo, float hi) { return lo + (hi - lo) * random.unit(); };
    const Vec3 center{uniform(-12, 12), uniform(-6, 6), uniform(-12, 12)};
    const Vec3 size{uniform(1, 6), uniform(1, 6), uniform(1, 6)};
    const float yaw = uniform(0, 6), pitch = uniform(-1, 1);
    b.block(center, size, [=](schema::Part::Builder p) {
      support::setRotation(p.initRotation(), yaw, pitch);
      if (number % 4 == 0) p.initKill();
      if (number % 5 == 0) p.initMotion().initSpin().setSpeed(2);
    });
  }
  return b.compile();
}

// Several parts contain the eye, so they are equally near.
TEST(OtherViews, DoNotDependOnTheOrderOfParts) {
  const level::Level one = scattered(40, false), two = scattered(40, true);
  for (const policy::Observe how : {rays, nearestParts, partSet})
    EXPECT_EQ(Onlooker(one).inputs(how), Onlooker(two).inputs(how));
}

TEST(OtherViews, AreOfOrderOneAndShowTheSurroundings) {
  const level::Level level = scattered(40, false);
  for (const policy::Observe how : {rays, nearestParts, partSet}) {
    const std::vector<float> in = Onlooker(level).inputs(how);
    const auto first = in.begin() + policy::kMapsAt, last = first + kViewInputs;
    EXPECT_GT(std::count_if(first, last, [](float v) { return v != 0; }), 20);
    EXPECT_TRUE(std::all_of(first, last, [](float v) { return std::abs(v) < 5; }));
    EXPECT_TRUE(std::all_of(last, in.end(), [](float v) { return v == 0; }));
  }
}

TEST(NearestParts, AreSorted) {
  const level::Level level = scattered(40, false);
  const List list{Onlooker(level).inputs(nearestParts)};
  ASSERT_EQ(list.count(), kListedParts);
  float before = 0;
  for (int i = 0; i < kListedParts; ++i) {
    Vec3 nearest{list(i, kPartNearest, 0), list(i, kPartNearest, 1), list(i, kPartNearest, 2)};
    const auto studs = [](float t) { return kNearPart * t / (1 - std::abs(t)); };
    nearest = {studs(nearest.x), studs(nearest.y), studs(nearest.z)};
    EXPECT_GE(length(nearest), before - 1e-3f) << i;
    before = length(nearest);
  }
  EXPECT_GT(before, 0);
}

// Inputs outside the maps equal those of the policy's own observation. Without parts nearby, the
// view is zero.
TEST(OtherViews, KeepThePolicysOtherInputs) {
  LevelBuilder far;
  far.block({200, -0.5f, 0}, {3, 1, 3});
  const level::Level level = far.compile();
  const std::vector<float> expected = Onlooker(level).inputs(policy::observe);
  for (const policy::Observe how : {rays, nearestParts, partSet})
    EXPECT_EQ(Onlooker(level).inputs(how), expected);
}

}  // namespace
}  // namespace obby::bench
