// The table rows that a stream of records produces.
#include "table/gathering.h"

#include <gmock/gmock.h>

#include "io/stream.h"

namespace obby::table_test {
namespace {

using table::State;

table::Gathering gathered(const std::vector<std::string>& lines) {
  std::string bytes;
  for (const std::string& line : lines) bytes += line + "\n";
  io::StreamReader reader = io::StreamReader::overBytes(bytes, "test");
  table::Gathering gathering;
  for (;;) {
    const auto record = reader.next();
    EXPECT_TRUE(record) << record.error().text();
    if (!record || !*record) return gathering;
    gathering.add((*record)->reader());
  }
}

const std::string kLevel =
    R"({"type":"level","name":"L","parts":[{"name":"Pad"}],)"
    R"("physics":{"controlRate":30},"spawns":[{"part":0},{"name":"Checkpoint"},{}]})";

TEST(Gathering, JoinsAQueryAndItsResult) {
  const auto answers =
      gathered({kLevel, R"({"type":"query","id":"q","goal":{"name":"Finish"}})",
                R"({"type":"trajectory","query":"q","level":"L"})",
                R"({"type":"result","query":"q","level":"L","verdict":"solved","ticks":45,)"
                R"("jumps":2,"reason":"There.","timing":{"firstSolution":0.5}})"})
          .answers();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].query, "q");
  EXPECT_EQ(answers[0].level, "L");
  EXPECT_EQ(answers[0].from, "Pad");
  EXPECT_EQ(answers[0].to, "Finish");
  EXPECT_EQ(answers[0].state, State::solved);
  EXPECT_EQ(answers[0].playTime, 1.5);
  EXPECT_EQ(answers[0].foundIn, 0.5);
  EXPECT_EQ(answers[0].jumps, 2u);
  EXPECT_EQ(answers[0].reason, "There.");
}

TEST(Gathering, DistinguishesQueriesOfSeveralLevels) {
  const auto answers = gathered({kLevel, R"({"type":"query","id":"q"})",
                                 R"({"type":"level","name":"M"})", R"({"type":"query","id":"q"})",
                                 R"({"type":"result","query":"q","level":"L","verdict":"unknown"})",
                                 R"({"type":"progress","query":"q","best":{"level":"M"}})"})
                           .answers();
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0].state, State::unknown);
  EXPECT_EQ(answers[1].state, State::noResult);
  EXPECT_EQ(answers[1].level, "M");
}

TEST(Gathering, AQueryAloneWasNotAsked) {
  const auto answers = gathered({kLevel, R"({"type":"query","id":"q"})"}).answers();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].state, State::notAsked);
}

TEST(Gathering, NamesPlacesAsInTheQuery) {
  const auto places = [](const std::string& fields) {
    const auto answers =
        gathered({kLevel, R"({"type":"query","id":"q",)" + fields + "}"}).answers();
    return answers.at(0).from + " to " + answers.at(0).to;
  };
  EXPECT_EQ(places(R"("start":{"spawn":1},"goal":{"part":"Pad"})"), "Checkpoint to Pad");
  EXPECT_EQ(places(R"("start":{"spawn":2},"goals":[{"name":"A"},{"name":"B"}])"),
            "start to A or 1 more");
  EXPECT_EQ(places(R"("start":{"spawn":9},"goal":{"position":[0,-0.01,-20.25]})"),
            "start to (0, 0, -20.3)");
  EXPECT_EQ(places(R"("start":{"region":{"name":"Door"}},"goal":{"name":"A"},"goals":[{},{}])"),
            "Door to A or 2 more");
  EXPECT_EQ(places(R"("maxJumps":3)"), "Pad to ");
}

}  // namespace
}  // namespace obby::table_test
