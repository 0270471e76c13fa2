// The importer reads place files back unchanged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gen/made.h"
#include "gen/place/place_file.h"
#include "import/importer.h"
#include "level/record_values.h"

namespace obby::test {
namespace {

using Parts = std::map<std::string, schema::Part::Reader>;

Parts partsOf(schema::Level::Reader level) {
  Parts parts;
  for (const auto part : level.getParts()) parts.emplace(part.getName().cStr(), part);
  EXPECT_EQ(parts.size(), level.getParts().size());
  return parts;
}

void expectNear(schema::Vec3::Reader a, schema::Vec3::Reader b, const std::string& what) {
  EXPECT_NEAR(a.getX(), b.getX(), 1e-4) << what;
  EXPECT_NEAR(a.getY(), b.getY(), 1e-4) << what;
  EXPECT_NEAR(a.getZ(), b.getZ(), 1e-4) << what;
}

// Compares rotations. A quaternion and its negative are the same rotation.
void expectSame(schema::Quat::Reader a, schema::Quat::Reader b, const std::string& what) {
  const float same =
      a.getX() * b.getX() + a.getY() * b.getY() + a.getZ() * b.getZ() + a.getW() * b.getW();
  EXPECT_NEAR(absf(same), 1, 1e-4) << what;
}

Vec3 turn(schema::Spin::Reader spin) { return level::vec(spin.getAxis()) * spin.getSpeed(); }

// Returns the bounding box of the part's position and its keys' positions.
Box motionBounds(schema::Part::Reader part) {
  const Vec3 home = level::vec(part.getPosition());
  Box box{home, home};
  for (const auto key : part.getMotion().getKeys()) {
    const Vec3 at = level::vec(key.getPosition());
    box = join(box, {at, at});
  }
  return box;
}

// Returns the seconds until a motion starts over, or 0 if there are no keys.
float roundOf(schema::Motion::Reader motion) {
  const auto keys = motion.getKeys();
  if (keys.size() == 0) return 0;
  const float duration = keys[keys.size() - 1].getTime() - keys[0].getTime();
  return motion.getRepeat() == schema::Repeat::PING_PONG ? 2 * duration : duration;
}

// Positions and times of tweens are written with all digits. Poses a few hundred studs from the
// origin lose digits in single precision. A carrier's script waits at both ends, and each wait may
// take one frame longer.
void expectSameRoute(schema::Part::Reader a, schema::Part::Reader b, const std::string& what) {
  // kFrame is in seconds; kRounding is in studs and in seconds. Motions are sampled once a frame,
  // and their keys lie on samples.
  constexpr float kFrame = 1.0f / 60, kRounding = 0.02f;
  const Box before = motionBounds(a), after = motionBounds(b);
  EXPECT_LT(length(before.lo - after.lo), kRounding) << what;
  EXPECT_LT(length(before.hi - after.hi), kRounding) << what;
  const float later = roundOf(b.getMotion()) - roundOf(a.getMotion());
  EXPECT_GT(later, -kRounding) << what;
  EXPECT_LT(later, kRounding + (a.getMotion().getCarries() ? 2 * kFrame : 0)) << what;
}

// Styles draw these times in quarters of a second. These are whole numbers of frames, so waits are
// exact.
void expectSame(schema::Vanish::Reader a, schema::Vanish::Reader b, const std::string& what) {
  EXPECT_EQ(int(a.getTrigger()), int(b.getTrigger())) << what;
  if (a.getTrigger() == schema::VanishTrigger::SIGNAL) return;  // the times of its button apply
  EXPECT_NEAR(a.getDelay(), b.getDelay(), 1e-4) << what;
  EXPECT_NEAR(a.getAway(), b.getAway(), 1e-4) << what;
  const float period = a.getDelay() + a.getAway();
  EXPECT_NEAR(std::remainder(a.getPhase() - b.getPhase(), period), 0, 1e-4) << what;
}

void expectSame(schema::Part::Reader a, schema::Part::Reader b) {
  const std::string what = a.getName().cStr();
  EXPECT_EQ(int(a.getShape()), int(b.getShape())) << what;
  expectNear(a.getPosition(), b.getPosition(), what);
  expectNear(a.getSize(), b.getSize(), what);
  expectSame(a.getRotation(), b.getRotation(), what);
  EXPECT_EQ(a.getFriction(), b.getFriction()) << what;
  EXPECT_EQ(a.getDensity(), b.getDensity()) << what;
  EXPECT_EQ(a.hasKill(), b.hasKill()) << what;
  EXPECT_EQ(a.hasGoal(), b.hasGoal()) << what;
  EXPECT_EQ(a.hasCheckpoint(), b.hasCheckpoint()) << what;
  EXPECT_EQ(a.getCheckpoint().getStage(), b.getCheckpoint().getStage()) << what;
  EXPECT_EQ(a.hasConveyor(), b.hasConveyor()) << what;
  expectNear(a.getConveyor().getVelocity(), b.getConveyor().getVelocity(), what);
  EXPECT_EQ(a.hasJumpPad(), b.hasJumpPad()) << what;
  expectNear(a.getJumpPad().getVelocity(), b.getJumpPad().getVelocity(), what);
  EXPECT_EQ(a.hasMotion(), b.hasMotion()) << what;
  EXPECT_EQ(a.getMotion().getCarries(), b.getMotion().getCarries()) << what;
  expectSameRoute(a, b, what);
  const auto turning = a.getMotion().getSpin(), back = b.getMotion().getSpin();
  EXPECT_LT(length(turn(turning) - turn(back)), 0.02f) << what;
  EXPECT_LT(length(level::vec(turning.getPivot()) - level::vec(back.getPivot())), 0.01f) << what;
  EXPECT_EQ(a.hasVanish(), b.hasVanish()) << what;
  if (b.hasVanish()) expectSame(a.getVanish(), b.getVanish(), what);
  // Dynamic parts stay dynamic. Carriers are also dynamic in the place, and are recognised by their
  // drive.
  if (!a.hasMotion()) {
    EXPECT_EQ(a.getAnchored(), b.getAnchored()) << what;
  }
}

class Places : public ::testing::TestWithParam<std::string> {};

TEST_P(Places, RoundTripThroughTheImporter) {
  const gen::Generator generator = generatorOf(recipeFor(GetParam(), 0.5f));
  for (uint64_t i = 0; i < 5; ++i) {
    gen::PlaceFile place(generator);
    ASSERT_TRUE(place.add(generator.generate(1, i)));
    const auto back = importer::importPlace(place.finish(), "made.rbxlx", {});
    ASSERT_TRUE(back) << back.error().text();
    const Made made = makeRecords(generator, 1, i);
    const auto level = back->level.reader().getLevel();
    const Parts before = partsOf(made.level.reader().getLevel()), after = partsOf(level);
    EXPECT_TRUE(back->warnings.empty()) << (back->warnings.empty() ? "" : back->warnings[0]);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [name, part] : before) {
      ASSERT_TRUE(after.count(name)) << name;
      expectSame(part, after.at(name));
    }
    EXPECT_EQ(level.getSpawns().size(), made.level.reader().getLevel().getSpawns().size());
    EXPECT_NEAR(level.getPhysics().getJumpSpeed(), 53, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Places, ::testing::ValuesIn(styleNames()), testName);

// A round checkpoint is a cylinder on its side. A player that respawned with its rotation would lie
// down. The cylinder's look direction is still level.
TEST(PlaceFile, ARespawnedPlayerStands) {
  gen::Recipe recipe = recipeFor("gaps", 0.5f);
  recipe.obstacles = {3, 3};
  recipe.turns = 1;
  const gen::Generator generator = generatorOf(recipe);
  const gen::Generated level = generator.generate(1, 0);
  int discs = 0;
  for (const gen::PartSketch& part : level.sketch.parts()) {
    if (part.checkpoint == 0) continue;
    const Mat3 axes = toMat3(part.rotation);
    EXPECT_NEAR(axes.z.y, 0, 1e-5f) << part.name;
    discs += axes.y.y < 0.5f;
  }
  EXPECT_GT(discs, 0);
  gen::PlaceFile place(generator);
  ASSERT_TRUE(place.add(level));
  const std::string file = place.finish();
  EXPECT_NE(file.find("character:PivotTo(CFrame.lookAt(at, at + pad.CFrame.LookVector))"),
            std::string::npos);
  EXPECT_EQ(file.find("pad.CFrame.Rotation"), std::string::npos);
}

TEST(PlaceFile, HasTheGravityAndTheSpeedsOfTheRecipe) {
  gen::Recipe recipe = recipeFor("gaps", 0.5f);
  recipe.physics = {{"gravity", 80}, {"walkSpeed", 54}, {"jumpSpeed", 40}};
  const gen::Generator generator = generatorOf(recipe);
  gen::PlaceFile place(generator);
  ASSERT_TRUE(place.add(generator.generate(1, 0)));
  const auto back = importer::importPlace(place.finish(), "made.rbxlx", {});
  ASSERT_TRUE(back) << back.error().text();
  const auto physics = back->level.reader().getLevel().getPhysics();
  EXPECT_EQ(physics.getGravity(), 80);
  EXPECT_EQ(physics.getWalkSpeed(), 54);
  EXPECT_NEAR(physics.getJumpSpeed(), 40, 1e-3) << "from a jump power";
}

TEST(PlaceFile, SeveralLevelsStandApart) {
  const gen::Generator generator = generatorOf({});
  gen::PlaceFile place(generator);
  size_t parts = 0;
  for (uint64_t i = 0; i < 8; ++i) {
    ASSERT_TRUE(place.add(generator.generate(3, i)));
    parts += generator.generate(3, i).sketch.parts().size();
  }
  const auto back = importer::importPlace(place.finish(), "made.rbxlx", {});
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(back->level.reader().getLevel().getParts().size(), parts);
  std::map<std::string, std::pair<float, float>> along;  // minimum and maximum X of each level
  for (const auto part : back->level.reader().getLevel().getParts()) {
    const std::string path = part.getSource().getPath().cStr();
    const std::string level = path.substr(0, path.rfind('/'));
    const float x = part.getPosition().getX();
    const auto [it, isNew] = along.try_emplace(level, x, x);
    it->second = {std::min(it->second.first, x), std::max(it->second.second, x)};
  }
  ASSERT_EQ(along.size(), 8u);
  std::vector<std::pair<float, float>> spans;
  for (const auto& [level, span] : along) spans.push_back(span);
  std::sort(spans.begin(), spans.end());
  for (size_t i = 1; i < spans.size(); ++i) EXPECT_GT(spans[i].first, spans[i - 1].second + 30);
}

// Adds the level repeatedly until the place is full.
Status filled(gen::PlaceFile& place, const gen::Generated& level, uint32_t& levels) {
  for (levels = 0; levels < 100000; ++levels) OBBY_RETURN_IF_ERROR(place.add(level));
  return {};
}

// A level may not extend beyond this distance, where floats are too coarse for a gap.
TEST(PlaceFile, HoldsALimitedNumberOfLevels) {
  const gen::Generator generator = generatorOf(recipeFor("walkway", 0));
  const gen::Generated level = generator.generate(1, 0);
  gen::PlaceFile place(generator);
  uint32_t levels = 0;
  const Status full = filled(place, level, levels);
  ASSERT_FALSE(full);
  EXPECT_GT(levels, 1000u);
  EXPECT_EQ(full.error().message, "a place file can hold at most " + std::to_string(levels) +
                                      " of these levels side by side within 1000000 studs");
  EXPECT_FALSE(place.add(level));
}

TEST(PlaceFile, StaysBelowTheImportersSizeLimit) {
  constexpr uint64_t kMax = 100000;
  const gen::Generator generator = generatorOf(recipeFor("walkway", 0));
  const gen::Generated level = generator.generate(1, 0);
  gen::PlaceFile place(generator, kMax);
  uint32_t levels = 0;
  const Status full = filled(place, level, levels);
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().message, "a place file can hold at most " + std::to_string(levels) +
                                      " of these levels in 100000 bytes");
  const std::string file = place.finish();
  EXPECT_LE(file.size(), kMax);
  const auto back = importer::importPlace(file, "made.rbxlx", {});
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(back->level.reader().getLevel().getParts().size(),
            levels * level.sketch.parts().size());
}

}  // namespace
}  // namespace obby::test
