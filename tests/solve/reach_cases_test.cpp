// Levels for which a bound on reach once claimed `unreachable`, each with a trajectory that solved
// it. The bound must contain the trajectory, and the query must not be unreachable if the
// trajectory still solves it.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "io/stream.h"
#include "scenes.h"
#include "solve/proof/unreachable.h"
#include "solve/verify/posed_query.h"

namespace obby::solve {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(OBBY_SOURCE_DIR) / ".." / "shared" / "cases" / "false-unreachable";

// Returns how many ticks of the trajectory were compared with the bound.
uint32_t expectHeld(const io::Record& level, const io::Record& query, const io::Record& played) {
  const auto compiled = level::Level::compile(level.reader().getLevel());
  EXPECT_TRUE(compiled);
  const auto asked = level::Query::compile(query.reader().getQuery(), *compiled);
  EXPECT_TRUE(asked);
  const PosedQuery posed{*compiled, level.reader().getLevel(), *asked, query.reader().getQuery()};
  const Problem problem = problemOf(posed);
  if (unboundedPart(problem.level) != nullptr) return 0;
  const ReachBound bound(problem, problem.query.maxJumps != 0);
  const auto plan = sim::planFromRecord(played.reader().getTrajectory());
  EXPECT_TRUE(plan);
  const auto end = sim::replay(problem.level, &problem.query, *plan, [&](const sim::Moment& m) {
    EXPECT_TRUE(bound.holds(m.world.position)) << "tick " << m.tick;
    return !testing::Test::HasFailure();
  });
  if (end.world.outcome == sim::Outcome::goal) {
    EXPECT_FALSE(cutOf(problem, query.reader().getQuery())) << "it is solved";
  }
  return end.ticks;
}

TEST(ReachCases, NoSolvedQueryIsUnreachable) {
  if (!fs::is_directory(kCases)) {
    GTEST_SKIP() << "NOT TESTED: the cases are missing: " << kCases.lexically_normal();
  }
  uint32_t ticks = 0;
  for (const auto& file : fs::directory_iterator(kCases)) {
    SCOPED_TRACE(file.path().filename());
    auto reader = io::StreamReader::open(file.path().string());
    ASSERT_TRUE(reader);
    std::optional<io::Record> level, query;
    for (;;) {
      const auto record = reader->next();
      ASSERT_TRUE(record) << record.error().text();
      if (!*record) break;
      if (!(*record)->known()) continue;
      if ((*record)->which() == io::Kind::LEVEL) level = **record;
      if ((*record)->which() == io::Kind::QUERY) query = **record;
      if ((*record)->which() != io::Kind::TRAJECTORY) continue;
      ASSERT_TRUE(level && query);
      ticks += expectHeld(*level, *query, **record);
    }
  }
  EXPECT_GT(ticks, 1000u);
}

}  // namespace
}  // namespace obby::solve
