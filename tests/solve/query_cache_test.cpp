// An endless stream keeps its newest queries for their trajectories.
#include "solve/query_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes.h"

namespace obby::solve {
namespace {

using testing::HasSubstr;
using testing::Not;

io::Record queryCalled(const std::string& id, float timeLimit = 1) {
  io::RecordBuilder record;
  auto query = record.root().initQuery();
  query.setId(id);
  query.setTimeLimit(timeLimit);
  return io::Record(std::move(record));
}

// Returns the bytes that a query takes if its id has one letter.
uint64_t queryCacheBytesOfOne() { return QueryCache::bytesOf("l", queryCalled("a")); }

std::string queryCacheErrorOf(const QueryCache& known, const std::string& level,
                              const std::string& id) {
  const auto found = known.named(level, id);
  return found ? "found" : found.error().text();
}

TEST(QueryCache, KeepsAsManyOfTheNewestAsFit) {
  QueryCache known(2 * queryCacheBytesOfOne());
  for (const char* id : {"a", "b", "c"}) known.add("l", queryCalled(id));
  EXPECT_EQ(queryCacheErrorOf(known, "l", "a"),
            "query: there is no query 'a' before this record, or it is one of 1 that were dropped "
            "from memory "
            "(put trajectories right after their query; only the newest queries are kept, up to "
            "0 MiB)");
  EXPECT_EQ(queryCacheErrorOf(known, "l", "b"), "found");
  EXPECT_EQ(queryCacheErrorOf(known, "l", "c"), "found");
  EXPECT_NE(queryCacheErrorOf(known, "other", "c"), "found");
}

TEST(QueryCache, KeepsTheNewestOfAnySize) {
  QueryCache known(1);
  for (const char* id : {"a", "b"}) known.add("l", queryCalled(id));
  EXPECT_NE(queryCacheErrorOf(known, "l", "a"), "found");
  EXPECT_EQ(queryCacheErrorOf(known, "l", "b"), "found");
}

TEST(QueryCache, ARepeatedIdReplacesTheQuery) {
  QueryCache known(2 * queryCacheBytesOfOne());
  for (const char* id : {"a", "b"}) known.add("l", queryCalled(id));
  known.add("l", queryCalled("a", 7));
  const auto again = known.named("l", "a");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->reader().getQuery().getTimeLimit(), 7.0f);
  known.add("l", queryCalled("c"));
  EXPECT_NE(queryCacheErrorOf(known, "l", "b"), "found");
  EXPECT_EQ(queryCacheErrorOf(known, "l", "a"), "found");
}

TEST(QueryCache, LeaveWithTheirLevelWithoutCountingAsDropped) {
  QueryCache known(queryCacheBytesOfOne() * 3);
  known.add("k", queryCalled("a"));
  for (const char* id : {"a", "b"}) known.add("l", queryCalled(id));
  known.forgetLevel("l");
  known.forgetLevel("never");
  EXPECT_EQ(queryCacheErrorOf(known, "k", "a"), "found");
  for (const char* id : {"a", "b"})
    EXPECT_THAT(queryCacheErrorOf(known, "l", id), Not(HasSubstr("dropped")));
  for (const char* id : {"c", "d"}) known.add("m", queryCalled(id));
  EXPECT_EQ(queryCacheErrorOf(known, "k", "a"), "found") << "a forgotten query takes no memory";
}

TEST(EndlessStream, TheErrorMentionsADroppedQuery) {
  const std::string text =
      stonesText() +
      R"({"type":"query","id":"r","level":"stones","goal":{"position":[0,2,-28]}})"
      "\n"
      R"({"type":"trajectory","query":"q","level":"stones","actions":[{"ticks":10}],"ticks":10})"
      "\n";
  const LinesFile file(text);
  FilterOptions o;
  o.task = Task::verify;
  o.queryBytes = 1;
  const Filtered f = runFilter(file.path(), std::move(o));
  ASSERT_FALSE(f.status);
  EXPECT_THAT(f.status.error().text(),
              HasSubstr(":4: query: there is no query 'q' before this record, or it is one of"));
}

}  // namespace
}  // namespace obby::solve
