// The model for Studio: parts along the trajectories. Nothing collides with these parts.
#include "view/trajectories_model.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <pugixml.hpp>

#include "view/course.h"
#include "view/thinning.h"

namespace obby::view {
namespace {

TEST(Thinning, KeepsPointsOffTheLine) {
  const std::vector<float> heights = {0, 0.01f, 0, 5, 0, 0, 0};
  const auto distance = [&](size_t a, size_t b, size_t p) {
    const float t = float(p - a) / float(b - a);
    return std::abs(heights[p] - (heights[a] + (heights[b] - heights[a]) * t));
  };
  EXPECT_EQ(thinned(heights.size(), 0.1f, distance), (std::vector<size_t>{0, 2, 3, 4, 6}));
  EXPECT_EQ(thinned(1, 0.1f, distance), (std::vector<size_t>{0}));
}

// Players who stand on a spinning part move in circles for hours.
TEST(Thinning, CirclesOfHoursTakeLessThanQuadraticTime) {
  constexpr size_t kPoints = 100'000, kRound = 60;
  std::vector<Vec3> round;
  for (size_t i = 0; i < kRound; ++i) {
    const float angle = 6.2831853f * float(i) / float(kRound);
    round.push_back({std::cos(angle), 0, std::sin(angle)});
  }
  size_t asked = 0;
  const auto distance = [&](size_t a, size_t b, size_t p) {
    ++asked;
    const Vec3 from = round[a % kRound];
    const Vec3 along = round[b % kRound] - from, off = round[p % kRound] - from;
    const float squared = dot(along, along);
    const float t = squared > 0 ? std::clamp(dot(off, along) / squared, 0.0f, 1.0f) : 0;
    return length(off - along * t);
  };
  const std::vector<size_t> kept = thinned(kPoints, 0.01f, distance);
  EXPECT_LT(asked, 300 * kPoints);
  float max = 0;
  for (size_t k = 0; k + 1 < kept.size(); ++k) {
    for (size_t p = kept[k] + 1; p < kept[k + 1]; ++p)
      max = std::max(max, distance(kept[k], kept[k + 1], p));
  }
  EXPECT_LE(max, 0.01f);
}

struct Counts {
  int segments = 0, jumps = 0, ends = 0, solid = 0;
};

void count(pugi::xml_node item, Counts& counts) {
  for (const pugi::xml_node child : item.children("Item")) {
    if (std::string(child.attribute("class").value()) == "Part") {
      const auto properties = child.child("Properties");
      const std::string name = properties.find_child_by_attribute("name", "Name").child_value();
      counts.segments += name == "Segment";
      counts.jumps += name == "Jump";
      counts.ends += name == "End";
      counts.solid += properties.find_child_by_attribute("name", "CanCollide").text().as_string() !=
                      std::string("false");
    }
    count(child, counts);
  }
}

TEST(TrajectoriesModel, HasEveryTrajectoryWithItsMarkers) {
  const Report report = view_test::solvedReport();
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(trajectoriesModel(report).c_str()));
  Counts counts;
  count(document.child("roblox"), counts);
  EXPECT_GT(counts.segments, 6);
  EXPECT_EQ(counts.ends, 2) << "the fall and the death";
  EXPECT_EQ(counts.solid, 0);
  const auto top = document.child("roblox").child("Item");
  EXPECT_EQ(std::distance(top.child("Item").children("Item").begin(),
                          top.child("Item").children("Item").end()),
            3)
      << "one model per trajectory";
}

// XML cannot represent control characters, even when they are escaped.
TEST(TrajectoriesModel, ControlCharactersInNamesLeaveItXml) {
  const std::string id = R"("id":"ahead")";
  std::string query = view_test::kQuery;
  query.replace(query.find(id), id.size(), R"("id":"a\u0001head")");
  auto trajectory = view_test::walk(view_test::kAhead, 200);
  trajectory.root().getTrajectory().setQuery("a\x01head");
  const auto report = view_test::collect({view_test::kLevel, query, view_test::line(trajectory)});
  ASSERT_TRUE(report) << report.error().text();
  const std::string text = trajectoriesModel(*report);
  EXPECT_EQ(text.find('\x01'), std::string::npos);
  EXPECT_NE(text.find("a head"), std::string::npos);
}

}  // namespace
}  // namespace obby::view
