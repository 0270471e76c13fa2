// The exact text of the answer table.
#include "table/answer_table.h"

#include <gmock/gmock.h>

#include <sstream>

#include "io/record.h"
#include "table/columns.h"

namespace obby::table_test {
namespace {

using table::Answer;
using table::State;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

Answer solved(const std::string& query) {
  Answer answer;
  answer.query = query;
  answer.from = "SpawnLocation";
  answer.to = "Checkpoint 1";
  answer.state = State::solved;
  answer.playTime = 8.4;
  answer.foundIn = 0.023;
  answer.jumps = 12;
  return answer;
}

Answer notAsked(const std::string& query) {
  Answer answer;
  answer.query = query;
  return answer;
}

Answer unknown(const std::string& query, const std::string& reason) {
  Answer answer;
  answer.query = query;
  answer.state = State::unknown;
  answer.reason = reason;
  return answer;
}

TEST(AnswerTable, ShowsTheStartAndTheGoalOfAQuery) {
  EXPECT_EQ(
      table::answerTable({solved("stage1"), unknown("stage2", "Too far.")}, {100, false, true}),
      "query   verdict  from → to                     play time  jumps  found in\n"
      "stage1  solved   SpawnLocation → Checkpoint 1     8.40 s     12    0.02 s\n"
      "stage2  unknown\n"
      "  Too far.\n");
}

TEST(AnswerTable, PlacesAreShortenedAndThenLeftOutOnNarrowTerminals) {
  const auto row = [](size_t width) {
    const std::string text = table::answerTable({solved("stage1")}, {width, false, false});
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(table::columnCount(line), width) << line;
    }
    return text;
  };
  EXPECT_THAT(row(80), HasSubstr("SpawnLocation -> Checkpoint 1"));
  EXPECT_THAT(row(70), HasSubstr("SpawnLo... -> Checkpo..."));
  EXPECT_THAT(row(50), Not(HasSubstr("->")));
}

TEST(AnswerTable, ATitleStandsInPlaceOfStartAndGoal) {
  io::RecordBuilder record;
  auto query = record.root().initQuery();
  query.initGoal().setName("Part");
  Answer answer = solved("stage1");
  query.setTitle("Stage 1: the start to 'Checkpoint 1'");
  table::describe(query, nullptr, answer);
  const std::string wide = table::answerTable({answer}, {100, false, true});
  EXPECT_THAT(wide, HasSubstr("stage1  solved   the start to 'Checkpoint 1'     8.40 s"));
  EXPECT_THAT(wide, Not(HasSubstr("Part")));
  const std::string narrow = table::answerTable({answer}, {70, false, false});
  EXPECT_THAT(narrow, HasSubstr("the start to 'Checkpo..."));
}

TEST(AnswerTable, OmitsColumnsThatNoRowNeeds) {
  EXPECT_EQ(table::answerTable({unknown("a", "")}, {80, false, false}),
            "query  verdict\n"
            "a      unknown\n");
  EXPECT_EQ(table::answerTable({}, {80, false, false}), "");
}

TEST(AnswerTable, QueriesThatWereNotAskedAreCountedBelowTheTable) {
  const std::string one = table::answerTable({notAsked("b"), solved("a")}, {80, false, false});
  EXPECT_THAT(one, Not(HasSubstr("\nb ")));
  EXPECT_THAT(one, EndsWith("\n1 other query was not asked in this run.\n"));
  EXPECT_THAT(table::answerTable({notAsked("b"), solved("a"), notAsked("c")}, {80, false, false}),
              EndsWith("\n2 other queries were not asked in this run.\n"));
}

TEST(AnswerTable, ListsAllQueriesIfNoneWasAsked) {
  EXPECT_EQ(table::answerTable({notAsked("a"), notAsked("b")}, {80, false, false}),
            "query  verdict\n"
            "a      not asked in this run\n"
            "b      not asked in this run\n");
}

TEST(AnswerTable, NamesAreHarmless) {
  Answer answer = solved("a\x1b[31m");
  answer.from = "b\nc";
  answer.reason = "d\re";
  const std::string text = table::answerTable({answer}, {120, false, true});
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, HasSubstr("b c → Checkpoint 1"));
  EXPECT_THAT(text, HasSubstr("d e\n"));
}

}  // namespace
}  // namespace obby::table_test
