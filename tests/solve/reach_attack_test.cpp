// No player leaves the bound on reach in random levels with random physics.
// OBBY_ATTACKS=COUNT tests more of them, from seed OBBY_ATTACK_SEED on.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "attack.h"

namespace obby::solve {
namespace {

uint64_t numberOf(const char* name, uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

void attackAll(bool features, uint16_t tricks = 0) {
  const uint64_t count = numberOf("OBBY_ATTACKS", 2500), first = numberOf("OBBY_ATTACK_SEED", 1);
  AttackCounts counts;
  int faults = 0;
  for (uint64_t seed = first; seed < first + count && faults < 20; ++seed) {
    const auto fault = Attack(seed, features, tricks).run(counts);
    if (!fault) continue;
    ++faults;
    ADD_FAILURE() << "seed " << seed << ": " << *fault;
  }
  std::printf("%llu levels, %llu without a bound, %llu where it holds all, %llu ticks\n",
              (unsigned long long)counts.levels, (unsigned long long)counts.unbounded,
              (unsigned long long)counts.wild, (unsigned long long)counts.ticks);
}

TEST(ReachAttack, NoPlayerLeavesTheBoundAmongBlocks) { attackAll(false); }
TEST(ReachAttack, NoPlayerLeavesTheBoundAmongAllParts) { attackAll(true); }

// Each trick has its own physics, which players could use to leave the bound.
TEST(ReachAttack, NoPlayerLeavesTheBoundByAHeldJump) { attackAll(false, kHeldJump); }
TEST(ReachAttack, NoPlayerLeavesTheBoundByAHangingLanding) { attackAll(false, kHangingLanding); }
TEST(ReachAttack, NoPlayerLeavesTheBoundByAWallHop) { attackAll(false, kWallHop); }
TEST(ReachAttack, NoPlayerLeavesTheBoundByALadderFlick) { attackAll(true, kLadderFlick); }
TEST(ReachAttack, NoPlayerLeavesTheBoundByALegThrow) { attackAll(false, kLegThrow); }
TEST(ReachAttack, NoPlayerLeavesTheBoundByAllTricks) { attackAll(true, kAllTricks); }

}  // namespace
}  // namespace obby::solve
