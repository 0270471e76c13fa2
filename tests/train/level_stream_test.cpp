// Levels of a stream are read on demand, repeated from the first at its end, and dropped once they
// are past.
#include "train/level_stream.h"

#include <cstring>
#include <functional>
#include <map>
#include <set>

#include "train/level_lines.h"

namespace obby::train {
namespace {

TEST(LevelStream, ReturnsLevelsByNumberInAnyOrder) {
  const LevelStream up(optionsOf(linesOf(6))), down(optionsOf(linesOf(6)));
  std::vector<uint64_t> hashes;
  for (uint64_t i = 0; i < 6; ++i) hashes.push_back(hashOf(up, i));
  for (uint64_t i = 6; i-- > 0;) EXPECT_EQ(hashOf(down, i), hashes[i]) << i;
  for (uint64_t i = 1; i < 6; ++i) EXPECT_NE(hashes[i], hashes[i - 1]);
  EXPECT_EQ(hashOf(up, 6), hashes[0]) << "it repeats";
  EXPECT_EQ(hashOf(up, 17), hashes[5]);
}

TEST(LevelStream, RepeatsTheLevelsThatItKept) {
  const LevelStream all(optionsOf(linesOf(4)));
  const LevelStream some(optionsOf(linesOf(4)),
                         {.keptBytes = 1});  // keeps at least the first level
  EXPECT_EQ(hashOf(some, 1), hashOf(all, 1));
  EXPECT_EQ(hashOf(some, 4), hashOf(all, 0));
  EXPECT_EQ(hashOf(some, 9), hashOf(all, 0));
}

TEST(LevelStream, DropsPastLevelsThatAreNotKept) {
  const LevelStream all(optionsOf(linesOf(8)));
  const LevelStream stream(optionsOf(linesOf(8)), {.keptBytes = 1});
  EXPECT_EQ(hashOf(stream, 5), hashOf(all, 5));
  stream.past(4);
  EXPECT_FALSE(stream.level(3, 1));
  EXPECT_EQ(hashOf(stream, 4), hashOf(all, 4));
  EXPECT_EQ(hashOf(stream, 0), hashOf(all, 0)) << "kept for repeating";
}

TEST(LevelStream, KeepsNoPastLevelIfItDoesNotRepeat) {
  const LevelStream all(optionsOf(linesOf(8)));
  const LevelStream once(optionsOf(linesOf(8)), {.again = false});
  hashOf(once, 5);
  once.past(4);
  EXPECT_FALSE(once.level(0, 1));
  EXPECT_FALSE(once.level(3, 1));
  for (uint64_t i = 4; i < 8; ++i) EXPECT_EQ(hashOf(once, i), hashOf(all, i)) << i;
  EXPECT_EQ(*once.level(8, 1), nullptr);
}

// A compiled level is many times as large as its records, which may be hundreds of megabytes.
TEST(LevelStream, HoldsNoCompiledLevelThatIsPast) {
  const LevelStream resumed(optionsOf(linesOf(400)), {.choices = 1});
  resumed.past(399);
  hashOf(resumed, 399);
  EXPECT_LE(resumed.compiledHeld(), 1u);
  const LevelStream shared(optionsOf(linesOf(400)), {.choices = 1});
  for (uint64_t i = 0; i < 400; i += 2) {  // another rank plays the odd levels
    hashOf(shared, i);
    EXPECT_LE(shared.compiledHeld(), 1u) << i;
    shared.past(i);
  }
  const LevelStream all(optionsOf(linesOf(2)));
  EXPECT_EQ(hashOf(shared, 401), hashOf(all, 1)) << "compiled again";
}

// Resuming within a stream takes no longer than reading the stream up to that level.
TEST(LevelStream, CompilesNoLevelThatIsPastAfterAResume) {
  const LevelStream all(optionsOf(linesOf(40)));
  const LevelStream resumed(optionsOf(linesOf(40)));
  resumed.past(30);
  EXPECT_EQ(hashOf(resumed, 35), hashOf(all, 35));
  EXPECT_EQ(resumed.compiledOnReading(), 6u);
  EXPECT_EQ(hashOf(resumed, 43), hashOf(all, 3)) << "compiled on demand";
  EXPECT_EQ(resumed.compiledOnReading(), 10u);
}

TEST(LevelStream, CompilesAllQueriesOfAPresentTurn) {
  const std::string easy = R"(,"difficulty":0)";
  // The turns: two queries, one query before a query without difficulty, that query, and two
  // queries.
  const LevelStream resumed(optionsOf(linesOf(6, {easy, easy, easy, "", easy, easy})),
                            {.choices = 2});
  resumed.past(2);
  hashOf(resumed, 3);
  EXPECT_EQ(resumed.compiledOnReading(), 3u);
}

// Levels that do not compile are not numbered, so all levels must be compiled.
TEST(LevelStream, CompilesAllLevelsIfErrorsAreForgiven) {
  io::SourceOptions options =
      optionsOf(lineOf(0) + lineOf(1, R"(,"difficulty":1.5)") + lineOf(2) + lineOf(3));
  options.onError = io::OnError::skip;
  const LevelStream all(optionsOf(linesOf(4))), resumed(std::move(options));
  resumed.past(2);
  EXPECT_EQ(hashOf(resumed, 2), hashOf(all, 3));
  EXPECT_EQ(resumed.compiledOnReading(), 3u);
}

// Levels read on the way to a much later one are kept as uncompiled records.
TEST(LevelStream, BoundsTheNumberOfCompiledLevels) {
  const LevelStream all(optionsOf(linesOf(40)));
  const LevelStream stream(optionsOf(linesOf(40)), {.compiledLevels = 8});
  EXPECT_EQ(hashOf(stream, 39), hashOf(all, 39));
  EXPECT_EQ(stream.compiledHeld(), 8u);
  for (uint64_t i = 0; i < 39; ++i) EXPECT_EQ(hashOf(stream, i), hashOf(all, i)) << i;
  EXPECT_EQ(stream.compiledHeld(), 0u);
}

// Without repetition, a turn drops its other queries when one of them is played.
TEST(LevelStream, ReturnsTheSameLevelAgain) {
  std::vector<std::string> more;
  for (int i = 0; i < 34; ++i)
    more.push_back(i % 2 == 0 ? R"(,"difficulty":0.1)" : R"(,"difficulty":0.9)");
  const LevelStream stream(optionsOf(linesOf(34, more)), {.keptBytes = 1, .choices = 2});
  for (uint64_t i = 1; i < 17; ++i) {
    const uint64_t hash = hashOf(stream, i);
    const auto again = stream.level(i, 0);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ((*again)->hash(), hash) << i;
  }
}

TEST(LevelStream, SkipsToTheLevelOfAResume) {
  const LevelStream all(optionsOf(linesOf(8)));
  const LevelStream stream(optionsOf(linesOf(8)), {.keptBytes = 1});
  stream.past(6);
  EXPECT_EQ(hashOf(stream, 6), hashOf(all, 6));
  EXPECT_FALSE(stream.level(5, 1));
}

// Text after the requested level is not read. Here it is not a record, and later levels would get
// wrong numbers.
TEST(LevelStream, ReadsOnlyUpToTheRequestedLevelAndNotBeyondAnError) {
  const LevelStream stream(optionsOf(linesOf(0).substr(0, linesOf(0).find('\n') + 1) + lineOf(0) +
                                     lineOf(1) + "this is no record\n" + lineOf(2) + lineOf(3)));
  const uint64_t first = hashOf(stream, 0);
  hashOf(stream, 1);
  for (const uint64_t index : {3, 2, 2}) {
    const auto broken = stream.level(index, 1);
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().text().find("levels:6"), std::string::npos) << broken.error().text();
  }
  EXPECT_EQ(hashOf(stream, 0), first) << "earlier levels remain";
}

TEST(LevelStream, NamesAQueryWhoseLevelWasDropped) {
  std::string text = linesOf(1);
  const std::string query = lineOf(0).substr(lineOf(0).find('\n') + 1);
  text.insert(text.find(R"({"type":"end")"),
              lineOf(1) + lineOf(2) + query);  // the query is of level 0, two levels before
  const LevelStream far(optionsOf(text), {.levelsInReach = 2}), near(optionsOf(text));
  const auto level = far.level(3, 1);
  ASSERT_FALSE(level);
  EXPECT_NE(level.error().text().find("no level '0' before this query (levels in memory: 2)"),
            std::string::npos)
      << level.error().text();
  EXPECT_EQ(hashOf(near, 3), hashOf(near, 0));
}

TEST(LevelStream, ReturnsNoLevelOnceItIsStopped) {
  std::atomic<bool> stop = false;
  io::SourceOptions options = optionsOf(linesOf(6));
  options.stop = &stop;
  const LevelStream stream(std::move(options));
  const uint64_t first = hashOf(stream, 0);
  hashOf(stream, 2);
  stop = true;
  const auto none = stream.level(4, 1);
  ASSERT_TRUE(none) << none.error().text();
  EXPECT_EQ(*none, nullptr) << "no repeated level, as at the end of the stream";
  EXPECT_EQ(hashOf(stream, 0), first) << "earlier levels remain";
}

TEST(LevelStream, HasEachLevelOnceIfItDoesNotRepeat) {
  const LevelStream all(optionsOf(linesOf(3)));
  const LevelStream once(optionsOf(linesOf(3)), {.again = false});
  const auto past = once.level(3, 1);
  ASSERT_TRUE(past) << past.error().text();
  EXPECT_EQ(*past, nullptr);
  for (uint64_t i = 0; i < 3; ++i) EXPECT_EQ(hashOf(once, i), hashOf(all, i)) << i;
}

// Returns the line of each level, from the width of its floor.
std::vector<uint64_t> linesGiven(const LevelStream& stream, uint64_t levels, float hardest) {
  std::vector<uint64_t> out;
  for (uint64_t i = 0; i < levels; ++i) {
    const auto level = *stream.level(i, hardest);
    out.push_back(uint64_t(2 * level->scene().level.bounds[0].box().hi.x + 0.5f) - 8);
  }
  return out;
}

TEST(LevelStream, ATurnPlaysAQueryThatIsNotTooHard) {
  const std::vector<std::string> hard = {R"(,"difficulty":0.9)", R"(,"difficulty":0.2)",
                                         R"(,"difficulty":0.5)", R"(,"difficulty":0.4)"};
  const std::string text = linesOf(4, hard);
  const LevelStream stream(optionsOf(text), {.choices = 4});
  for (const auto& [hardest, lines] : std::map<float, std::set<uint64_t>>{
           {0.0f, {1}}, {0.2f, {1}}, {0.45f, {1, 3}}, {0.5f, {1, 2, 3}}, {1.0f, {0, 1, 2, 3}}}) {
    const std::vector<uint64_t> given = linesGiven(stream, 64, hardest);
    EXPECT_EQ(std::set<uint64_t>(given.begin(), given.end()), lines) << hardest;
    EXPECT_EQ(linesGiven(LevelStream(optionsOf(text), {.choices = 4}), 64, hardest), given);
  }
}

TEST(LevelStream, TurnsHaveQueriesWithADifficulty) {
  const std::string easy = R"(,"difficulty":0)", hard = R"(,"difficulty":1)";
  // The turns: two queries, one query without difficulty, one before another query without
  // difficulty, that query, and the rest.
  const std::string text = linesOf(6, {hard, easy, "", easy, "", hard});
  const LevelStream stream(optionsOf(text), {.choices = 2});
  EXPECT_EQ(linesGiven(stream, 10, 0.5f), (std::vector<uint64_t>{1, 2, 3, 4, 5, 1, 2, 3, 4, 5}));
  const LevelStream each(optionsOf(text), {.again = false, .choices = 1});
  EXPECT_EQ(linesGiven(each, 6, 0), (std::vector<uint64_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(*each.level(6, 0), nullptr);
}

TEST(LevelStream, AQueryWithoutALevelBelongsToTheOneBeforeIt) {
  std::string text = linesOf(3);
  for (const char* name : {R"("level":"0",)", R"("level":"2",)"})
    text.erase(text.find(name), std::strlen(name));
  const LevelStream stream(optionsOf(text));
  ASSERT_TRUE(stream.level(2, 1)) << stream.level(2, 1).error().text();
  EXPECT_EQ(linesGiven(stream, 3, 1), (std::vector<uint64_t>{0, 1, 2}));
  const LevelStream none(optionsOf(R"({"type":"query","id":"q"})"
                                   "\n"));
  const auto level = none.level(0, 1);
  ASSERT_FALSE(level);
  EXPECT_EQ(level.error().text(), "levels:1: there is no level before this query");
}

// Returns a hand-written level, and a query whose goal is a part that it names.
std::string linesTo(const std::string& part) {
  return fmt::format(
      R"({{"type":"level","parts":[{{"shape":"block","position":[0,-0.5,0],"size":[20,1,40]}},)"
      R"({{"name":"Finish","shape":"block","position":[3,0.5,-12],"size":[4,1,4]}}]}})"
      "\n"
      R"({{"type":"query","id":"q","start":{{"region":{{"position":[0,2.5,0],"size":[4,5,4]}}}},)"
      R"("goal":{{"part":"{}"}}}})"
      "\n",
      part);
}

TEST(LevelStream, RegionsMayNameParts) {
  const LevelStream stream(optionsOf(linesTo("Finish")));
  for (const uint64_t index : {0, 1}) {
    const auto level = stream.level(index, 1);
    ASSERT_TRUE(level) << level.error().text();
    EXPECT_EQ((*level)->scene().query.goal.region.pose.position.x, 3);
  }
  const LevelStream wrong(optionsOf(linesTo("Nowhere")));
  const auto level = wrong.level(0, 1);
  ASSERT_FALSE(level);
  EXPECT_EQ(level.error().text().find("levels:2: goal.part: "), 0u) << level.error().text();
}

TEST(LevelStream, RefusesADifficultyOutOfRange) {
  const LevelStream stream(optionsOf(linesOf(1, {R"(,"difficulty":1.5)"})));
  const auto level = stream.level(0, 1);
  ASSERT_FALSE(level);
  EXPECT_NE(level.error().text().find("levels:3: difficulty: expected a number from 0 (trivial)"),
            std::string::npos)
      << level.error().text();
}

// Records that cannot be read, and records without a valid meaning.
TEST(LevelStream, SkipsBadRecordsIfErrorsAreForgiven) {
  const LevelStream all(optionsOf(linesOf(3)));
  std::vector<std::string> errors;
  io::SourceOptions options = optionsOf(lineOf(0) + R"({"type":"level","parts":7})" + "\n" +
                                        lineOf(1, R"(,"difficulty":1.5)") + lineOf(2));
  options.onError = io::OnError::skip;
  options.report = [&](const Error& error) { errors.push_back(error.text()); };
  const LevelStream some(std::move(options));
  EXPECT_EQ(hashOf(some, 0), hashOf(all, 0));
  EXPECT_EQ(hashOf(some, 1), hashOf(all, 2));
  EXPECT_EQ(hashOf(some, 2), hashOf(all, 0)) << "it repeats";
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].find("levels:3: parts: "), 0u) << errors[0];
  EXPECT_EQ(errors[1].find("levels:5: difficulty: "), 0u) << errors[1];
}

TEST(LevelStream, NeedsALevel) {
  const LevelStream empty(optionsOf(linesOf(0)));
  const auto none = empty.level(0, 1);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("no level with"), std::string::npos);
}

}  // namespace
}  // namespace obby::train
