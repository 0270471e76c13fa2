// Trajectories that pass a place, also between two ticks.
#include "solve/pass_filter.h"

#include <fmt/format.h>

#include "walked_answer.h"

namespace obby::solve {
namespace {

class PassFilterTest : public VerifierTest {
 protected:
  explicit PassFilterTest(LevelBuilder stones = steppingStones())
      : VerifierTest(std::move(stones)) {}

  bool keeps(const PassRule& rule) {
    auto filter = PassFilter::make(record.reader().getLevel(), level, rule);
    EXPECT_TRUE(filter) << filter.error().text();
    auto kept = filter->keeps(level, trajectory.reader().getTrajectory());
    EXPECT_TRUE(kept) << kept.error().text();
    return *kept;
  }
};

TEST_F(PassFilterTest, AThinBoxIsPassedBetweenTicks) {
  makeTrajectory();
  for (int i = 0; i < 30; ++i) {
    const float z = -16 - 0.01f * float(i);
    const std::string across = fmt::format("0,2,{},8,4,0.002", z);
    const std::string nextTo = fmt::format("40,2,{},8,4,0.002", z);
    EXPECT_TRUE(keeps({{across}, {}})) << z;
    EXPECT_FALSE(keeps({{}, {across}})) << z;
    EXPECT_FALSE(keeps({{nextTo}, {}})) << z;
    EXPECT_TRUE(keeps({{}, {nextTo}})) << z;
    EXPECT_TRUE(keeps({{across}, {nextTo}})) << z;
  }
}

TEST_F(PassFilterTest, TheStartIsPassed) {
  makeTrajectory();
  EXPECT_TRUE(keeps({{"0,0,-2,0.1,1,0.1"}, {}}));
}

// A trajectory that passes a forbidden place is rejected even if it passes that place last.
TEST_F(PassFilterTest, AForbiddenPlaceAfterAllOthersCounts) {
  makeTrajectory();
  const std::string early = "0,2,-6,8,4,2", late = "0,6,-22,8,16,2";
  EXPECT_TRUE(keeps({{early, late}, {}}));
  EXPECT_TRUE(keeps({{late, early}, {}})) << "in any order";
  EXPECT_FALSE(keeps({{early}, {late}}));
  EXPECT_FALSE(keeps({{late}, {early}}));
}

// A teleporter at the end of the first stone leads to the third.
class TeleportedPassFilterTest : public PassFilterTest {
 protected:
  TeleportedPassFilterTest() : PassFilterTest(teleporting()) {}
  static LevelBuilder teleporting() {
    LevelBuilder b = steppingStones();
    b.block({0, 3, -7}, {8, 6, 1}, [](schema::Part::Builder p) {
      p.setSolid(false);
      support::set(p.initTeleport().initPosition(), {0, 0, -28});
    });
    return b;
  }
};

TEST_F(TeleportedPassFilterTest, ATeleportPassesNothingInBetween) {
  ASSERT_EQ(makeTrajectory(false).getOutcome(), schema::Outcome::GOAL);
  EXPECT_TRUE(keeps({{"0,2,-28,8,4,8"}, {}}));
  EXPECT_FALSE(keeps({{"0,2,-16,8,8,2"}, {}}));
}

}  // namespace
}  // namespace obby::solve
