// The search's answers are the same on every machine, compiler and optimisation level, tick for
// tick and bit for bit. tests/golden/answers.tsv holds solutions of queries of levels/ by plain
// search, by search guided by the shipped policy, and by the methods that learn while they search.
// After a deliberate change of the simulator, the search, the shipped policy or these levels, run:
//   OBBY_WRITE_GOLDEN=1 test_golden --gtest_filter='Golden.Answers*' && git diff tests/golden
#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string_view>

#include "base/hash.h"
#include "base/thread_pool.h"
#include "baselines/methods.h"
#include "golden/committed.h"
#include "io/stream.h"
#include "policy/shipped_policy.h"
#include "sim/simulator.h"

namespace obby::solve {
namespace {

constexpr const char* kFile = OBBY_SOURCE_DIR "/tests/golden/answers.tsv";

struct Asked {
  const char* level;
  const char* query;
  const char* method = "auto";
  bool guided = false;  // uses the shipped policy
  uint64_t maxSteps = 1'000'000;
};
constexpr Asked kAsked[] = {
    {"kill-checkerboard", "cross"}, {"vanishing-run", "blinks"},    {"wedge-climb", "whole"},
    {"sliding-planks", "cross"},    {"lava-ring", "through-ring"},  {"spiral-tower", "to-half"},
    {"timed-jumps", "posts"},       {"several-routes", "no-jumps"},
};

// Observations, networks, sampled actions and learning decide these answers. The levels have still,
// moving, climbable, vanishing and dynamic parts, and some queries stay unsolved. Budgets are
// small: a round of `ge-ps` has 8,192 rollouts, `rl` ends after one round or tens of rounds, and
// `pbge` and `cflge` learn for about twenty rounds.
constexpr Asked kPlayedByNetworks[] = {
    {"spiral-tower", "to-half", "auto", true, 1'000'000},
    {"suite/crates-and-walls", "first-wall", "auto", true, 300'000},
    {"suite/moving-gauntlet", "whole", "auto", true, 300'000},
    {"suite/log-roll-disc", "along", "auto", true, 60'000},
    {"suite/gaps", "gap-10.5", "ge-ps", true, 1'000'000},
    {"vanishing-run", "blinks", "ge-ps", true, 1'000'000},
    {"suite/truss-hurdles-bare", "cross", "ge-ps", true, 400'000},
    {"kill-checkerboard", "cross", "rl", true, 100'000},
    {"push-box", "onto-the-wall", "rl", true, 100'000},
    {"suite/orchard", "unhurt", "rl", true, 100'000},
    {"suite/triple-spinner-walls", "cross", "rl", true, 100'000},
    {"suite/gaps", "gap-13", "rl", true, 60'000},
    {"ladder", "up-the-ladder", "pbge", false, 200'000},
    {"kill-checkerboard", "cross", "pbge", false, 60'000},
    {"suite/crates-and-walls", "first-wall", "pbge", false, 40'000},
    {"ladder", "up-the-ladder", "cflge", false, 100'000},
    {"goal-too-high", "second-lift", "cflge", false, 100'000},
    {"suite/crates-and-walls", "first-wall", "cflge", false, 30'000},
};

SearchOutcome searched(const Asked& asked, const level::Level& level, const level::Query& query) {
  ThreadPool pool(2);
  Budget budget;
  budget.maxSteps = asked.maxSteps;
  Problem problem{level.view(),
                  query.view(),
                  sim::makeWorld(level.view(), query.start()),
                  sim::startBodies(level.view()),
                  level.bounds(),
                  level.hasMotion()};
  if (asked.guided) problem.policy = &policy::shippedPolicy().network;
  return baselines::findMethod(asked.method)->run(problem, budget, {}, pool);
}

// Returns one line: level, query, method and steps, then the solution's ticks, jumps and state
// hash. Without a solution, the count of cells and a hash of the attempts' end states follow
// instead.
std::string lineOf(const Asked& asked, const SearchOutcome& o) {
  std::ostringstream out;
  out << asked.level << '\t' << asked.query << '\t' << asked.method
      << (asked.guided ? "+policy" : "") << '\t' << o.statistics.steps;
  if (!o.solutions.empty()) {
    const Trajectory& p = o.solutions.front();
    out << '\t' << p.ticks << '\t' << p.end.jumps << '\t' << sim::stateHash(p.end, p.endBodies);
    return out.str();
  }
  uint64_t ends = 0;
  for (const Trajectory& p : o.attempts) {
    const uint64_t end = sim::stateHash(p.end, p.endBodies);
    ends = hashBytes(&end, sizeof end, ends);
  }
  out << "\tunsolved\t" << o.cells << '\t' << ends;
  return out.str();
}

std::string answer(const Asked& asked) {
  auto reader =
      io::StreamReader::open(std::string(OBBY_SOURCE_DIR "/levels/") + asked.level + ".jsonl");
  EXPECT_TRUE(reader) << reader.error().text();
  std::optional<level::Level> level;
  while (true) {
    auto record = reader->next();
    if (!record || !*record) break;
    if ((*record)->which() == io::Kind::LEVEL) {
      auto compiled = level::Level::compile((*record)->reader().getLevel());
      EXPECT_TRUE(compiled) << compiled.error().text();
      level.emplace(*std::move(compiled));
    }
    if ((*record)->which() != io::Kind::QUERY) continue;
    const auto queryRecord = (*record)->reader().getQuery();
    if (std::string_view(queryRecord.getId().cStr()) != asked.query) continue;
    const auto query = level::Query::compile(queryRecord, *level);
    EXPECT_TRUE(query) << query.error().text();
    return lineOf(asked, searched(asked, *level, *query));
  }
  return std::string(asked.level) + "\tno query " + asked.query;
}

TEST(Golden, AnswersOfTheSuiteAreBitForBitAsCommitted) {
  std::string now;
  for (const Asked& asked : kAsked) now += answer(asked) + "\n";
  for (const Asked& asked : kPlayedByNetworks) now += answer(asked) + "\n";
  golden::expectCommitted(kFile, now);
}

}  // namespace
}  // namespace obby::solve
