// The page contains all data, and escapes it safely.
#include "view/page.h"

#include <gmock/gmock.h>

#include <cmath>

#include "course.h"
#include "io/json_tree.h"
#include "view/budget.h"
#include "view/page_parts.h"
#include "view/page_template.h"

namespace obby::view_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Page, DataNamesLevelQueryAndTrajectories) {
  const std::string data = view::pageData(solvedReport(), {false, "obby-view test"});
  EXPECT_THAT(data, HasSubstr(R"("id":"ahead")"));
  EXPECT_THAT(data, HasSubstr(R"("verdict":"solved")"));
  EXPECT_THAT(data, HasSubstr(R"("kind":"solution")"));
  EXPECT_THAT(data, HasSubstr(R"("outcome":"killed","part":1)"));
  EXPECT_THAT(data, HasSubstr("Workspace/Rock"));
  EXPECT_THAT(data, HasSubstr(R"("name":"middle")"));
  EXPECT_THAT(data, Not(HasSubstr("</script>")));
  EXPECT_THAT(data, Not(HasSubstr("mismatch")));
}

TEST(Page, DataIsWholeJsonThatCannotEndTheScript) {
  const std::string data = view::pageData(solvedReport(), {false, "obby-view test </script>"});
  EXPECT_EQ(data.find('<'), std::string::npos);
  const auto tree = io::JsonTree::parse(data);
  ASSERT_TRUE(tree) << tree.error().text();
  EXPECT_EQ(tree->text(*tree->find(tree->root(), "generator")), "obby-view test </script>");
  EXPECT_NE(tree->find(tree->root(), "queries"), nullptr);
}

TEST(Page, AQueryMayHaveATitle) {
  auto report = collect({R"({"type":"level","name":"L","parts":[{"name":"A"},{"name":"B"}]})",
                         R"({"type":"query","id":"stage1","title":"Stage 1: 'A' to 'B'",)"
                         R"("start":{"region":{"part":"A"}},"goal":{"part":"B"}})"});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::pageData(*report, {}),
              HasSubstr(R"("id":"stage1","level":0,"title":"Stage 1: 'A' to 'B'")"));
}

TEST(Page, TagsAreThoseOfTheRecord) {
  auto report = collect({R"({"type":"level","name":"L","parts":[{},{"tags":["Lava","Hot"]}]})"});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::pageData(*report, {}), HasSubstr(R"("tags":{"1":["Lava","Hot"]})"));
}

TEST(Page, MaterialsAreNamedOnceAndFitInAByte) {
  std::string level = R"({"type":"level","name":"L","parts":[{},{"material":"Wood"})";
  for (int i = 0; i < 300; ++i) level += R"(,{"material":"M)" + std::to_string(i) + R"("})";
  auto report = collect({level + R"(,{"material":"Wood"}]})"});
  ASSERT_TRUE(report) << report.error().text();
  const std::string data = view::pageData(*report, {});
  EXPECT_THAT(data, HasSubstr(R"("material":"AAECAwQF)")) << "0, 1, 2, ...";
  EXPECT_THAT(data, HasSubstr(R"("materials":["","Wood","M0","M1")"));
  EXPECT_THAT(data, HasSubstr(R"("M253"])")) << "255 names and none";
  EXPECT_THAT(data, HasSubstr(R"(AAAAAAAAAAB")")) << "plastic beyond, and Wood is found again";
}

// Times in seconds would drift from the simulation, which counts whole ticks.
TEST(Page, TimersAreInTheTicksThatAreSimulated) {
  auto report = collect({R"({"type":"level","name":"L","parts":[)"
                         R"({"vanish":{"trigger":"timer","delay":0.508,"away":0.508}},)"
                         R"({"vanish":{"trigger":"timer","delay":2,"away":2,"phase":-1}},)"
                         R"({"vanish":{"trigger":"touch","delay":1,"away":2}}]})"});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::pageData(*report, {}),
              HasSubstr(R"("vanish":[{"part":0,"trigger":"timer","delay":30,"away":30,"phase":0},)"
                        R"({"part":1,"trigger":"timer","delay":120,"away":120,"phase":180},)"
                        R"({"part":2,"trigger":"touch"}])"));
}

TEST(Page, ATooLargePageNamesWhatToOmit) {
  const size_t bytes = view::kPageLimit + (5u << 20);
  EXPECT_THAT(view::pageTooLarge(bytes, true).text(), HasSubstr("205 MB"));
  EXPECT_THAT(view::pageTooLarge(bytes, true).hint, HasSubstr("leave out --full"));
  EXPECT_EQ(view::pageTooLarge(bytes, false).hint, "choose queries with --query");
}

TEST(Page, MismatchIsShown) {
  auto path = walk(kAhead, 200);
  path.root().getTrajectory().setStateHash(1);
  auto report = collect({kLevel, kQuery, line(path), resultLine("solved", 80)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::pageData(*report, {}), HasSubstr(R"("mismatch":"the last state differs)"));
}

TEST(Page, NamesTheHardestStep) {
  auto path = walk(kAhead, 200);
  auto difficulty = path.root().getTrajectory().initDifficulty();
  difficulty.setBand(schema::Band::HARD);
  difficulty.setHardest(1);
  auto steps = difficulty.initSteps(2);
  steps[1].setStartTick(30);
  steps[1].setTo(1);
  steps[1].setBand(schema::Band::HARD);
  steps[0].setTicks(30);
  steps[1].setJumps(1);
  steps[1].setWindow(250);
  steps[1].setMargin(-0.5f);
  steps[1].setClearance(0);
  auto report = collect({kLevel, kQuery, line(path), resultLine("solved", 80)});
  ASSERT_TRUE(report) << report.error().text();
  const std::string data = view::pageData(*report, {});
  EXPECT_THAT(data, HasSubstr(R"("difficulty":{"band":"hard")"));
  EXPECT_THAT(data, HasSubstr(R"("hardest":{"startTick":30,"ticks":0,"from":-1,"to":1)"));
  EXPECT_THAT(data, HasSubstr(R"("steps":[{"startTick":0,"ticks":30},{"startTick":30,"ticks":0,)"
                              R"("window":250,"margin":-0.5,"clearance":0}])"));
  // The difficulty names a hardest step that does not exist.
  difficulty.setHardest(2);
  report = collect({kLevel, kQuery, line(path), resultLine("solved", 80)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::pageData(*report, {}), Not(HasSubstr("difficulty")));
}

// Cap'n Proto keeps values of later schema versions, for which the page has no colour.
TEST(Page, ValuesOfLaterVersionsAreUnknown) {
  auto path = walk(kAhead, 200);
  auto difficulty = path.root().getTrajectory().initDifficulty();
  difficulty.setBand(schema::Band(99));
  difficulty.initSteps(1)[0].setBand(schema::Band(99));
  io::RecordBuilder answer(recordOf(resultLine("solved", 80)).reader());
  answer.root().getResult().setVerdict(schema::Verdict(99));
  view::Collector collector([](const io::Record&, Error error) -> Status { return error; });
  ASSERT_TRUE(collector.add(recordOf(kLevel)));
  ASSERT_TRUE(collector.add(io::Record(std::move(path))));
  ASSERT_TRUE(collector.add(io::Record(std::move(answer))));
  ASSERT_TRUE(collector.update());
  const std::string data = view::pageData(collector.report(), {});
  EXPECT_THAT(data, HasSubstr(R"("difficulty":{"band":"unknown")"));
  EXPECT_THAT(data, HasSubstr(R"("jumps":0,"band":"unknown","window")"));
  EXPECT_THAT(data, HasSubstr(R"("verdict":"unknown")"));
}

TEST(Page, ShowsAdviceRoutesAndConfidence) {
  const std::string answer =
      R"({"type":"result","query":"ahead","level":"Course </script><b>","verdict":"unknown",)"
      R"("relaxations":[{"kind":"jumps","part":2,"text":"solvable with 3 jumps instead of 2"}],)"
      R"("routes":[{"route":[0,2],"count":"7","ticks":90}],)"
      R"("heatMap":{"size":4,"cubes":[{"feet":[1,2,3],"cells":7}]},)"
      R"("evidence":{"saturation":"growing","newCellChance":0.5}})";
  auto report = collect({kLevel, kQuery, answer});
  ASSERT_TRUE(report) << report.error().text();
  const std::string data = view::pageData(*report, {});
  EXPECT_THAT(
      data,
      HasSubstr(
          R"("relaxations":[{"text":"solvable with 3 jumps instead of 2","part":2,"avoid":-1}])"));
  EXPECT_THAT(data, HasSubstr(R"("routes":[{"count":"7","ticks":90,"route":[0,2]}])"));
  EXPECT_THAT(data,
              HasSubstr(R"("heatMap":{"size":4,"feet":"AACAPwAAAEAAAEBA","counts":"BwAAAA=="})"));
  EXPECT_THAT(data, HasSubstr(R"("evidence":{"saturation":"growing","newCellChance":0.5})"));
}

TEST(Page, HoldsTheProofsCut) {
  const std::string answer =
      R"({"type":"result","query":"ahead","level":"Course </script><b>","verdict":"unreachable",)"
      R"("cut":{"reached":[0,2],"from":2,"rise":4.5,"gap":1,"jumps":3,"seconds":2},)"
      R"("ends":[{"outcome":"avoided","avoid":1,"count":"9"}]})";
  auto report = collect({kLevel, kQuery, answer});
  ASSERT_TRUE(report) << report.error().text();
  const std::string data = view::pageData(*report, {});
  EXPECT_THAT(data, HasSubstr(R"("cut":{"reached":[0,2],"from":2,"to":-1,"rise":4.5,"gap":1,)"
                              R"("jumps":3,"seconds":2})"));
  EXPECT_THAT(data, HasSubstr(R"({"outcome":"avoided","part":-1,"avoid":1,"count":"9"})"));
}

TEST(Page, TellsTheRouteOfATrajectory) {
  auto path = walk(kAhead, 200);
  auto route = path.root().getTrajectory().initRoute(2);
  route.set(0, 0);
  route.set(1, 4);
  auto report = collect({kLevel, kQuery, line(path), resultLine("solved", 80)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::pageData(*report, {}), HasSubstr(R"("avoid":-1,"route":[0,4])"));
}

TEST(Page, HoldsDataOnceAndEscapesTheTitle) {
  if (!view::pageAvailable()) GTEST_SKIP() << "BUILT WITHOUT THE VIEWER PAGE (npm): not tested";
  const auto page = view::htmlPage(solvedReport(), {});
  ASSERT_TRUE(page) << page.error().text();
  EXPECT_THAT(*page, HasSubstr("<title>Course &lt;/script&gt;&lt;b&gt;</title>"));
  EXPECT_THAT(*page, Not(HasSubstr("@@OBBY_")));
  EXPECT_THAT(*page, HasSubstr(R"("id":"ahead")"));
  EXPECT_THAT(*page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(*page, Not(HasSubstr("<script src")));
}

TEST(Page, OnlyALivePageMayContactItsServer) {
  if (!view::pageAvailable()) GTEST_SKIP() << "BUILT WITHOUT THE VIEWER PAGE (npm): not tested";
  const auto live = view::livePage(), file = view::htmlPage(solvedReport(), {});
  ASSERT_TRUE(live && file);
  EXPECT_THAT(*live, HasSubstr("default-src 'none'; connect-src 'self'; script-src"));
  EXPECT_THAT(*file, Not(HasSubstr("connect-src")));
  EXPECT_THAT(*live, HasSubstr(R"({"format":4,"live":true})"));
  EXPECT_THAT(*live, Not(HasSubstr("@@OBBY_")));
}

TEST(Page, MarkersInNamesStayText) {
  if (!view::pageAvailable()) GTEST_SKIP() << "BUILT WITHOUT THE VIEWER PAGE (npm): not tested";
  std::string level = kLevel;
  level.replace(level.find("Course </script><b>"), 19, "@@OBBY_DATA@@");
  auto report = collect({level});
  ASSERT_TRUE(report) << report.error().text();
  const auto page = view::htmlPage(*report, {});
  ASSERT_TRUE(page) << page.error().text();
  EXPECT_THAT(*page, HasSubstr("<title>@@OBBY_DATA@@</title>"));
  EXPECT_THAT(*page, HasSubstr(R"("title":"@@OBBY_DATA@@")"));
}

TEST(Page, ExplainsHowToGetAMissingBundle) {
  if (view::pageAvailable()) {
    EXPECT_THAT(view::pageMissing().hint, HasSubstr("npm"));
  } else {
    const auto page = view::htmlPage(solvedReport(), {});
    ASSERT_FALSE(page);
    EXPECT_THAT(page.error().text(), HasSubstr("npm"));
  }
}

TEST(Tracks, CoverOnePeriodOfEachMotion) {
  const view::Report report = solvedReport();
  const auto tracks = tracksOf(report.levels[0], 100000, 1);
  ASSERT_EQ(tracks.size(), 2u);
  const view::Track& lift = tracks[0];
  EXPECT_EQ(lift.part, 2u);
  EXPECT_EQ(lift.count, 120u);
  EXPECT_EQ(lift.loopFrom, 0);
  EXPECT_TRUE(lift.rotations.empty());
  EXPECT_NEAR(lift.positions[1], 2, 1e-4);
  EXPECT_NEAR(lift.positions[3 * 60 + 1], 8, 1e-4);
  const view::Track& fan = tracks[1];
  EXPECT_EQ(fan.part, 3u);
  EXPECT_TRUE(fan.positions.empty());
  // At 3 rad/s about Y, 20 ticks are a rotation of 1 rad, so the half angle is 0.5.
  EXPECT_NEAR(fan.rotations[4 * 20 + 1], std::sin(0.5f) * 32767, 40);
  EXPECT_NEAR(fan.rotations[4 * 20 + 3], std::cos(0.5f) * 32767, 40);
}

TEST(Tracks, MotionLongerThanThePageIsCutAndStridesKeepItsTimes) {
  const view::Report report = solvedReport();
  const view::LevelEntry& level = report.levels[0];
  const auto cut = tracksOf(level, 60, 1);
  EXPECT_EQ(cut[0].count, 61u);
  EXPECT_EQ(cut[0].loopFrom, -1);
  EXPECT_GE((tracksOf(level, 60, 8)[0].count - 1) * 8, 60u);
  const auto thinned = tracksOf(level, 100000, 4);
  EXPECT_EQ(thinned[0].count, 30u);
  EXPECT_NEAR(thinned[0].positions[3 * 15 + 1], 8, 1e-4);
}

}  // namespace
}  // namespace obby::view_test
