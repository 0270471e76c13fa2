// Tracks place parts on the page as the simulator does.
#include "view/tracks.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "course.h"
#include "view/page.h"

namespace obby::view_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// The keys determine position and rotation, even if they are constant. The part's own pose has no
// effect.
TEST(Tracks, StayAtThePoseOfConstantKeys) {
  auto report = collect({R"({"type":"level","name":"L","parts":[)"
                         R"({"size":[8,1,2],"rotation":[0,0.70710678,0,0.70710678],)"
                         R"("motion":{"keys":[{},{"time":1,"position":[0,6,0]}]}},)"
                         R"({"size":[8,1,2],"position":[5,0,0],"motion":{"keys":[)"
                         R"({"position":[9,3,0]},)"
                         R"({"time":1,"position":[9,3,0],"rotation":[0,1,0,0]}]}}]})"});
  ASSERT_TRUE(report) << report.error().text();
  const auto tracks = tracksOf(report->levels[0], 1200, 1);
  ASSERT_EQ(tracks.size(), 2u);
  ASSERT_EQ(tracks[0].rotations.size(), 4u * tracks[0].count);
  EXPECT_EQ(tracks[0].rotations[1], 0) << "not turned";
  EXPECT_EQ(std::abs(tracks[0].rotations[3]), 32767);
  ASSERT_EQ(tracks[1].positions.size(), 3u * tracks[1].count);
  EXPECT_THAT(std::vector<float>(tracks[1].positions.begin(), tracks[1].positions.begin() + 3),
              ElementsAre(9.0f, 3.0f, 0.0f));
}

// With a period of one or two seconds, one sample in 64 ticks would lose the motion. A stride that
// does not divide the period would keep all samples.
TEST(Tracks, KeepEnoughSamplesOfAShortPeriod) {
  const view::Report report = solvedReport();
  const auto tracks = tracksOf(report.levels[0], 100000, 64);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].stride, 8u) << "of 120 ticks";
  EXPECT_EQ(tracks[0].count, 15u);
  EXPECT_EQ(tracks[0].loopFrom, 0);
  const auto opens = collect({R"({"type":"level","name":"L","parts":[{"size":[8,1,2],)"
                              R"("motion":{"repeat":"once","keys":[{},)"
                              R"({"time":0.5,"position":[0,6,0]}]}}]})"});
  ASSERT_TRUE(opens) << opens.error().text();
  const auto once = tracksOf(opens->levels[0], 1200, 64);
  ASSERT_EQ(once.size(), 1u);
  EXPECT_EQ(once[0].stride, 2u) << "of 30 ticks";
  EXPECT_NEAR(once[0].positions.end()[-2], 6, 1e-4);
}

// If a part always has the rotation of its keys, its track needs no rotations, in spite of
// rounding.
TEST(Tracks, OmitRotationsIfTheRotationIsConstant) {
  auto report = collect({R"({"type":"level","name":"L","parts":[{"size":[8,1,2],)"
                         R"("rotation":[0.1234567,0.2,0.3,0.9],"motion":{"keys":[)"
                         R"({"rotation":[0.1234567,0.2,0.3,0.9]},)"
                         R"({"time":1,"position":[0,6,0],)"
                         R"("rotation":[0.1234567,0.2,0.3,0.9]}]}}]})"});
  ASSERT_TRUE(report) << report.error().text();
  const auto tracks = tracksOf(report->levels[0], 1200, 1);
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_FALSE(tracks[0].positions.empty());
  EXPECT_TRUE(tracks[0].rotations.empty());
}

TEST(Page, APartWithOneKeyIsAtThatKey) {
  auto report = collect({R"({"type":"level","name":"L","parts":[{"position":[3,3,3],)"
                         R"("motion":{"keys":[{"position":[7,1,0]}]}}]})"});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::pageData(*report, {}), HasSubstr(R"("position":"AADgQAAAgD8AAAAA")"));
}

// The player collides with the hull's box.
TEST(Page, AnUnknownHullIsABox) {
  auto report =
      collect({R"({"type":"level","name":"L","parts":[{"size":[8,1,2],"shape":"hull"}]})"});
  ASSERT_TRUE(report) << report.error().text();
  const std::string data = view::pageData(*report, {});
  EXPECT_THAT(data, HasSubstr(R"("shape":"AA==")"));
  EXPECT_THAT(data, HasSubstr(R"("hulls":[])"));
  EXPECT_THAT(data, Not(HasSubstr(R"("pieces")")));
}

}  // namespace
}  // namespace obby::view_test
