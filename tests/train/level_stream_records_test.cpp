// The records that a stream keeps, and records other than levels and queries.
#include "train/level_lines.h"

namespace obby::train {
namespace {

size_t bytesOf(const std::string& line) {
  io::StreamReader reader = io::StreamReader::overBytes(line, "line");
  const auto record = reader.next();
  if (!record || !*record) return 0;
  return (*record)->reader().totalSize().wordCount * sizeof(capnp::word);
}

// Returns a level with many parts, and queries with different goals.
std::string largeLevel() {
  std::string parts = R"({"shape":"block","position":[0,-0.5,0],"size":[20,1,40]})";
  for (int i = 0; i < 200; ++i)
    parts += fmt::format(R"(,{{"shape":"block","position":[{},-0.5,{}],"size":[4,1,4]}})",
                         6 * (i % 20), 60 + 6 * (i / 20));
  return fmt::format(R"({{"type":"level","name":"large","parts":[{}]}})", parts) + "\n";
}

std::string queryOfLarge(uint64_t number) {
  return fmt::format(
      R"({{"type":"query","id":"q","level":"large","start":{{"region":{{"position":[0,2.5,0],"size":[4,5,4]}}}},)"
      R"("goal":{{"position":[0,2,{}],"size":[4,4,4]}}}})"
      "\n",
      -4 - int(number));
}

TEST(LevelStream, ALevelCountsOnceForAnyNumberOfQueries) {
  constexpr uint64_t kQueries = 20;
  const std::string level = largeLevel();
  const size_t bytes = bytesOf(level);
  ASSERT_GT(bytes, kQueries * bytesOf(queryOfLarge(0)));
  std::string text = level;
  for (uint64_t i = 0; i < kQueries; ++i) text += queryOfLarge(i);
  const LevelStream all(optionsOf(text)), some(optionsOf(text), {.keptBytes = 3 * bytes});
  for (uint64_t i = 0; i < kQueries; ++i)
    EXPECT_EQ(hashOf(some, kQueries + i), hashOf(all, i)) << i;
}

TEST(LevelStream, KeepsLevelsUpToABudgetOfBytes) {
  const std::string query = lineOf(0).substr(lineOf(0).find('\n') + 1);
  const std::string text = kHeaderLine + lineOf(0) + lineOf(1) + query;  // of level 0
  const LevelStream all(optionsOf(text)), last(optionsOf(text), {.bytesInReach = 1});
  EXPECT_EQ(hashOf(all, 2), hashOf(all, 0));
  EXPECT_EQ(hashOf(last, 1), hashOf(all, 1));
  const auto level = last.level(2, 1);
  ASSERT_FALSE(level);
  EXPECT_EQ(level.error().text(),
            "levels:6: there is no level '0' before this query (levels in memory: 1)");
}

// As in obby-solve, parameters apply to later levels. A level's own values take precedence.
TEST(LevelStream, LevelsUseTheParametersBeforeThem) {
  std::string own = lineOf(2);
  own.insert(own.find(R"("parts")"), R"("physics":{"walkSpeed":24},)");
  const LevelStream stream(optionsOf(
      lineOf(0) + R"({"type":"params","gravity":150,"walkSpeed":20})" + "\n" + lineOf(1) + own));
  const float walkSpeeds[] = {16, 20, 24};
  for (uint64_t i = 0; i < 3; ++i) {
    const auto level = stream.level(i, 1);
    ASSERT_TRUE(level) << level.error().text();
    const Params& params = (*level)->scene().level.params;
    EXPECT_EQ(params.walkSpeed, walkSpeeds[i]) << i;
    EXPECT_EQ(params.gravity, i == 0 ? 196.2f : 150.0f) << i;
  }
}

}  // namespace
}  // namespace obby::train
