// An endless stream keeps its newest levels. Older ones are dropped with their queries.
#include "solve/level_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes.h"

namespace obby::solve {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

LevelCache::LevelPointer levelCalled(const std::string& name) {
  io::RecordBuilder record;
  auto level = record.root().initLevel();
  level.setName(name);
  support::set(level.initParts(1)[0].initSize(), {8, 1, 8});
  level.initSpawns(1);
  auto loaded = loadLevel(io::Record(std::move(record)));
  EXPECT_TRUE(loaded) << loaded.error().text();
  return std::make_shared<const LoadedLevel>(*std::move(loaded));
}

// Returns the bytes that a level takes if its name has one letter.
uint64_t bytesOfOne() { return bytesOf(*levelCalled("a")); }

std::string errorOf(const LevelCache& known, const std::string& name) {
  const auto found = known.named(name);
  return found ? "found" : found.error().text();
}

TEST(LevelCache, KeepsAsManyOfTheNewestAsFit) {
  LevelCache known(2 * bytesOfOne());
  EXPECT_THAT(known.add(levelCalled("a")), IsEmpty());
  EXPECT_THAT(known.add(levelCalled("b")), IsEmpty());
  EXPECT_THAT(known.add(levelCalled("c")), ElementsAre("a"));
  EXPECT_THAT(errorOf(known, "a"),
              HasSubstr("level: there is no level 'a' before this record, or it is one of 1 that "
                        "were dropped from memory (put queries"));
  EXPECT_EQ(errorOf(known, "b"), "found");
  EXPECT_EQ(errorOf(known, "c"), "found");
}

// Two parts far apart make a small record and a large grid.
TEST(LevelCache, CountsTheMemoryOfACompiledLevel) {
  io::RecordBuilder record;
  auto level = record.root().initLevel();
  auto parts = level.initParts(2);
  for (auto part : parts) support::set(part.initSize(), {8, 1, 8});
  support::set(parts[1].initPosition(), {1000, 0, 1000});
  level.initSpawns(1);
  const auto loaded = loadLevel(io::Record(std::move(record)));
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_GT(bytesOf(*loaded), 200000u);
  EXPECT_LT(bytesOfOne(), 20000u);
}

TEST(LevelCache, KeepsTheNewestOfAnySize) {
  LevelCache known(1);
  EXPECT_THAT(known.add(levelCalled("a")), IsEmpty());
  EXPECT_EQ(errorOf(known, "a"), "found");
  EXPECT_THAT(known.add(levelCalled("b")), ElementsAre("a"));
  EXPECT_EQ(errorOf(known, "b"), "found");
}

TEST(LevelCache, ARepeatedNameReplacesTheLevel) {
  LevelCache known(2 * bytesOfOne());
  EXPECT_THAT(known.add(levelCalled("a")), IsEmpty());
  EXPECT_THAT(known.add(levelCalled("b")), IsEmpty());
  const auto again = levelCalled("a");
  EXPECT_THAT(known.add(again), IsEmpty());
  EXPECT_EQ(*known.named("a"), again);
  EXPECT_THAT(known.add(levelCalled("c")), ElementsAre("b"));
}

TEST(LevelCache, AForgottenLevelDoesNotCountAsDropped) {
  LevelCache known(bytesOfOne());
  EXPECT_THAT(known.add(levelCalled("a")), IsEmpty());
  known.forget("a");
  known.forget("never");
  EXPECT_THAT(errorOf(known, "a"), Not(HasSubstr("dropped")));
  EXPECT_THAT(errorOf(known, ""), HasSubstr("no level before this record"));
  EXPECT_THAT(known.add(levelCalled("b")), IsEmpty());
}

// Verifies the trajectories of a stream, with at most `levelBytes` for kept levels. Returns "fine"
// or the error.
std::string verdictOn(const std::string& text, uint64_t levelBytes) {
  FilterOptions o;
  o.task = Task::verify;
  o.levelBytes = levelBytes;
  const LinesFile file(text);
  const Filtered f = runFilter(file.path(), std::move(o));
  return f.status ? "fine" : f.status.error().text();
}

const std::string kOther =
    R"({"type":"level","name":"other","parts":[{"size":[8,1,8]}],"spawns":[{}]})"
    "\n";

TEST(EndlessStream, TheErrorMentionsADroppedLevel) {
  const std::string text =
      stonesText() + kOther +
      R"({"type":"query","id":"late","level":"stones","goal":{"position":[0,2,-28]}})"
      "\n";
  EXPECT_EQ(verdictOn(text, LevelCache::kMaxBytes), "fine");
  EXPECT_THAT(
      verdictOn(text, 1),
      HasSubstr(":4: level: there is no level 'stones' before this record, or it is one of"));
}

TEST(EndlessStream, QueriesGoWithTheirLevel) {
  const std::string stones = stonesText();
  const std::string text =
      stones + kOther + stones.substr(0, stones.find('\n') + 1) +
      R"({"type":"trajectory","query":"q","level":"stones","actions":[{"ticks":10}],"ticks":10})"
      "\n";
  EXPECT_THAT(verdictOn(text, LevelCache::kMaxBytes), Not(HasSubstr("no query")));
  EXPECT_THAT(verdictOn(text, 1), HasSubstr(":5: query: there is no query 'q' before this record"));
}

TEST(EndlessStream, AnIdIsNamedOnce) {
  FilterOptions o;
  o.only = {"nope"};
  const LinesFile file(stonesText() + stonesText());
  const Filtered f = runFilter(file.path(), std::move(o));
  ASSERT_FALSE(f.status);
  EXPECT_THAT(f.status.error().text(), HasSubstr("(it has 'q')"));
}

}  // namespace
}  // namespace obby::solve
