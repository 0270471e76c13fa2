// The search's answers are the same on every machine, compiler and optimisation level: the
// solutions of some queries of levels/, tick for tick and bit for bit, as tests/golden/answers.tsv
// has them. After a change of the simulator, the search or these levels that is meant to change
// answers:
//   OBBY_WRITE_GOLDEN=1 test_golden && git diff tests/golden
#include <gtest/gtest.h>

#include <sstream>

#include "base/thread_pool.h"
#include "golden/committed.h"
#include "io/stream.h"
#include "sim/simulator.h"
#include "solve/methods.h"

namespace obby::solve {
namespace {

constexpr const char* kFile = OBBY_SOURCE_DIR "/tests/golden/answers.tsv";

struct Asked {
  const char* level;
  const char* query;
};
constexpr Asked kAsked[] = {
    {"kill-checkerboard", "cross"}, {"vanishing-run", "blinks"},    {"wedge-climb", "whole"},
    {"sliding-planks", "cross"},    {"lava-ring", "through-ring"},  {"spiral-tower", "to-half"},
    {"timed-jumps", "posts"},       {"several-routes", "no-jumps"},
};

// One line: level, query, steps, ticks, jumps, state hash.
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
    const auto query = level::Query::compile((*record)->reader().getQuery(), *level);
    EXPECT_TRUE(query) << query.error().text();
    if (query->id() != asked.query) continue;
    ThreadPool pool(2);
    Budget budget;
    budget.maxSteps = 1'000'000;
    const Problem problem{level->view(),
                          query->view(),
                          sim::makeWorld(level->view(), query->start()),
                          sim::makeLoose(level->view()),
                          level->bounds(),
                          level->hasMotion()};
    const SearchOutcome o = findMethod("auto")->run(problem, budget, {}, pool);
    std::ostringstream line;
    line << asked.level << '\t' << asked.query << '\t' << o.statistics.steps;
    if (!o.solutions.empty()) {
      const Playthrough& p = o.solutions.front();
      line << '\t' << p.ticks << '\t' << p.end.jumps << '\t' << sim::stateHash(p.end, p.endLoose);
    }
    return line.str();
  }
  return std::string(asked.level) + "\tno query " + asked.query;
}

TEST(Golden, AnswersOfTheSuiteAreBitForBitAsCommitted) {
  std::string now;
  for (const Asked& asked : kAsked) now += answer(asked) + "\n";
  golden::expectCommitted(kFile, now);
}

}  // namespace
}  // namespace obby::solve
