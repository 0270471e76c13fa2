// What moving parts do to those around them, worked out once for all queries of a level.
#include "solve/proof/part_motion.h"

#include <gtest/gtest.h>

#include "scenes.h"
#include "solve/proof/supports.h"

namespace obby::solve {
namespace {

TEST(PartMotions, AreWorkedOutOnceAndAlike) {
  const level::Level level = support::movingArena(20, 6, 1).compile();
  PartMotions kept;
  const std::vector<PartMotion>& motions = kept.of(level.view());
  EXPECT_EQ(motions.size(), 6u);
  EXPECT_EQ(&kept.of(level.view()), &motions);
  Problem problem = support::plainProblem(level, {});
  const std::vector<Support> anew = supportsOf(problem);
  problem.motions = &kept;
  const std::vector<Support> again = supportsOf(problem);
  ASSERT_EQ(again.size(), anew.size());
  for (size_t i = 0; i < anew.size(); ++i) {
    EXPECT_EQ(again[i].upward, anew[i].upward);
    EXPECT_EQ(again[i].sideways, anew[i].sideways);
    EXPECT_EQ(again[i].entry, anew[i].entry);
  }
}

}  // namespace
}  // namespace obby::solve
