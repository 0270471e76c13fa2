// Tests the search for the part that took too much health, which the simulator does not report.
#include "solve/search/rollouts/blame.h"

#include <gtest/gtest.h>

#include "hand_played.h"
#include "solve/search/methods/go_explore.h"
#include "solve/search/resident/resident_explore.h"

namespace obby::solve {
namespace {

// Returns the stones with a hurting curtain over the first stone, and another curtain far away.
LevelBuilder curtain() {
  const auto hot = [](schema::Part::Builder p) {
    p.setSolid(false);
    p.initKill().setDamage(20);
    p.getKill().setCooldown(10);
  };
  return steppingStones().block({30, 5, -5}, {8, 40, 1}, hot).block({0, 5, -5}, {40, 40, 1}, hot);
}
constexpr uint32_t kCurtain = 4;

struct Hot {
  explicit Hot(float maxDamage = 10) {
    asked.query.maxDamage = maxDamage;
    problem = asked.problem();
  }
  sim::World walked() const {
    return playByHand(problem, [](const sim::World&) { return sim::Action{0, true, false}; }).end;
  }
  level::Level level = curtain().compile();
  PlainQuery asked{level};
  Problem problem = asked.problem();
};

TEST(Blame, NamesThePartThatTookTooMuchHealth) {
  const Hot hot;
  const sim::World end = hot.walked();
  ASSERT_EQ(end.outcome, sim::Outcome::hurt);
  EXPECT_EQ(end.part, level::kNone);
  EXPECT_EQ(blamedPart(end, nullptr, hot.level.view()), kCurtain);
}

TEST(Blame, KeepsThePartOfOtherEnds) {
  const Hot hot(50);
  const sim::World end = hot.walked();
  ASSERT_EQ(end.outcome, sim::Outcome::fell);
  EXPECT_EQ(blamedPart(end, nullptr, hot.level.view()), level::kNone);
  sim::World killed = end;
  killed.outcome = sim::Outcome::killed;
  killed.part = 2;
  EXPECT_EQ(blamedPart(killed, nullptr, hot.level.view()), 2u);
}

void expectNamed(const Search& search) {
  uint64_t hurt = 0;
  for (const EndCount& e : search.attempts().counts()) {
    if (e.outcome != sim::Outcome::hurt) continue;
    EXPECT_EQ(e.part, kCurtain);
    hurt += e.count;
  }
  EXPECT_GT(hurt, 0u);
}

TEST(Blame, SearchesCountItByPart) {
  const Hot hot;
  ThreadPool pool(2);
  GoExplore explore(hot.problem, 1, GoExploreSettings{}, pool);
  ResidentSettings few;
  few.explore.rollouts = few.explore.maxRollouts = 256;
  ResidentExplore resident(hot.problem, 1, few, pool);
  for (Search* search : {static_cast<Search*>(&explore), static_cast<Search*>(&resident)}) {
    for (int i = 0; i < 6; ++i) search->round();
    expectNamed(*search);
  }
}

}  // namespace
}  // namespace obby::solve
