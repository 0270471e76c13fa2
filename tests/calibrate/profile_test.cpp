// Parameters without a gradient are found by trial: times in whole ticks, and parameters that
// decide when events happen.
#include "calibrate/profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calibrate/course.h"
#include "calibrate/crossing.h"
#include "calibrate/ticks.h"

namespace obby::calibrate {
namespace {

TEST(Profile, KeepsValuesWithinTheSlack) {
  const Profile profile{0, {0.1, 0.2, 0.3, 0.4}, {5, 1.2, 1, 3}};
  const Possible some = possibleOf(profile, 0.3), one = possibleOf(profile, 0.1);
  EXPECT_EQ(some.min, 0.2);
  EXPECT_EQ(some.max, 0.3);
  EXPECT_FALSE(some.all);
  EXPECT_EQ(one.min, 0.3);
  EXPECT_TRUE(possibleOf(profile, 10).all);
}

io::RecordBuilder with(std::initializer_list<std::pair<const char*, double>> values) {
  io::RecordBuilder out;
  auto params = out.root().initParams();
  for (const auto& [name, value] : values) setValue(params, name, value);
  return out;
}

// Returns a recording of a player who runs off the ledge three times, and presses jump later each
// time.
std::vector<Take> lateJumps(schema::PhysicsParams::Reader params) {
  std::vector<Manoeuvre> played;
  for (const float wait : {0.84f, 0.87f, 0.90f})
    played.push_back({"late", {-30, 8.1f, 4}, {{0.3f, 0, 0}, {wait, 1, 0}, {0.3f, 1, 0, true}}});
  return takesUnder(params, 0, played);
}

std::vector<Profile> scanned(const std::vector<Take>& takes, const std::vector<std::string>& names,
                             std::vector<uint32_t>& best) {
  Undisturbed hands;
  const Objective objective(takes, *parametersNamed(names, defaults()), defaults(), {});
  Scan scan = scanOf(objective, objective.start(), Tried::inPairs, hands.work);
  for (size_t i = 0; i < names.size(); ++i) {
    const double seconds = valueAt(objective.parameters()[i], scan.best[i]);
    best.push_back(uint32_t(std::lround(seconds * 60)));
  }
  return std::move(scan.profiles);
}

// One tick is equivalent to two, because the tick that lands and the tick that runs again both
// count.
TEST(Ticks, LandingTicksAreFound) {
  for (const int ticks : {0, 2, 6}) {
    const io::RecordBuilder truth = with({{"landedTime", ticks / 60.0}});
    const Manoeuvre jumps{"jumps", {0, 0.1f, 0}, {{0.5f, 0, 0}, {2.5f, 0, 0, true}}};
    std::vector<uint32_t> best;
    scanned(takesUnder(truth.reader().getParams(), 0, {jumps}), {"landedTime"}, best);
    EXPECT_EQ(best[0], uint32_t(ticks));
  }
}

// The jump needs both times to be long, so no change of one time alone has an effect.
TEST(Ticks, FindsTwoTimesThatMaskEachOther) {
  const io::RecordBuilder truth = with({{"coyoteTime", 0.25}, {"offFloorGrace", 0.25}});
  const auto takes = lateJumps(truth.reader().getParams());
  std::vector<uint32_t> best;
  const auto profiles = scanned(takes, {"coyoteTime", "offFloorGrace"}, best);
  std::vector<uint32_t> alone;
  scanned(takes, {"coyoteTime"}, alone);
  EXPECT_EQ(alone[0], 7u) << "as at the start: the other time hides it";
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_GT(best[i], 7u);
    EXPECT_LE(best[i], 15u);
    const Possible possible = possibleOf(profiles[i], 1e-6);
    EXPECT_FALSE(possible.all);
    EXPECT_EQ(possible.max, profiles[i].shares.back()) << "no player jumped even later";
  }
}

TEST(Ticks, StayUnchangedWithoutAnEffect) {
  const Manoeuvre stands{"stands", {0, 0.1f, 0}, {{1, 0, 0}}};
  std::vector<uint32_t> best;
  const auto profiles =
      scanned(takesUnder(defaults(), 0, {stands}), {"coyoteTime", "landedTime"}, best);
  EXPECT_EQ(best, (std::vector<uint32_t>{7, 3}));
  for (const Profile& p : profiles) EXPECT_TRUE(possibleOf(p, 0).all);
}

// The player jumps again at each landing, when the legs sense the floor. Nothing else in the
// recording depends on the parameter.
TEST(Crossing, FindsTheHeightAtWhichAFloorIsSensed) {
  const io::RecordBuilder truth = with({{"floorAcquire", 1.02}});
  std::vector<Manoeuvre> falls;
  for (int i = 0; i < 12; ++i)
    falls.push_back({"falls", {0, 2 + 0.09f * float(i), 0}, {{1, 0, 0, true}}});
  const auto takes = takesUnder(truth.reader().getParams(), 0, falls);
  const Objective objective(takes, *parametersNamed({"floorAcquire"}, defaults()), defaults(), {});
  Undisturbed hands;
  const double before = objective.loss(objective.start());
  const Crossing crossing =
      crossingOf(objective, objective.start(), 0, sharesAllOver(), 3, hands.work);
  EXPECT_LT(crossing.loss, 1e-6 * before);
  const Possible possible = possibleOf(crossing.profile, 1e-6 * before);
  const Parameter& p = objective.parameters()[0];
  EXPECT_LE(valueAt(p, possible.min), 1.02);
  EXPECT_LT(valueAt(p, possible.max), 1.1) << "what it was is ruled out";
}

}  // namespace
}  // namespace obby::calibrate
