// The line along which a level is built is the `route` of its query. It stays on the course,
// follows the order of parts, and crosses no gap wider than a jump.
#include <algorithm>

#include "gen/made.h"

namespace obby::test {
namespace {

constexpr uint64_t kRouteSeeds = 12;
constexpr float kSideMargin = 3.25f;  // studs next to the floors, since hops lead to both sides
constexpr float kAbove = 0.51f;  // studs above or below the tops, since lines do not climb buttons
constexpr float kStep = 0.5f;    // studs between the samples of a line

// A part, and the range over which its centre moves.
struct Ground {
  Mat3 axes;  // each axis is vertical or horizontal
  Vec3 half, from, to;
  bool carries;
};

std::vector<Ground> groundsOf(const gen::Sketch& sketch) {
  std::vector<Ground> grounds;
  for (const gen::PartSketch& p : sketch.parts()) {
    Ground g{toMat3(p.rotation), p.size * 0.5f, p.position, p.position, p.solid && !p.kill};
    if (p.motion && !p.motion->keys.empty()) {
      g.from = p.motion->keys.front().position;
      g.to = p.motion->keys.back().position;
    }
    grounds.push_back(g);
  }
  return grounds;
}

// Horizontal distance of a point from a part, and its height above the part's top, in studs.
struct Off {
  float sideways, above;
};

// Returns the offset of `at`. `share` is the progress of the part's motion, from 0 to 1.
Off offAt(const Ground& g, Vec3 at, float share) {
  const Vec3 middle = g.from + (g.to - g.from) * share;
  const Vec3 out = max(abs(toLocal(g.axes, at - middle)) - g.half, Vec3{});
  const Vec3 upright = abs(Vec3{g.axes.x.y, g.axes.y.y, g.axes.z.y});
  return {length(mul(out, Vec3{1, 1, 1} - upright)), at.y - middle.y - dot(upright, g.half)};
}

template <class Is>
bool anywhere(const Ground& g, Vec3 at, const Is& is) {
  const int steps = g.from == g.to ? 0 : 32;
  for (int i = 0; i <= steps; ++i) {
    if (is(offAt(g, at, steps == 0 ? 0.0f : float(i) / float(steps)))) return true;
  }
  return false;
}

bool standsOn(const Ground& g, Vec3 at) {
  return g.carries && anywhere(g, at, [](const Off& off) {
           return off.sideways <= kSideMargin && absf(off.above) <= kAbove;
         });
}

bool isOver(const std::vector<Ground>& grounds, Vec3 at) {
  return std::any_of(grounds.begin(), grounds.end(), [&](const Ground& g) {
    return g.carries && anywhere(g, at, [](const Off& off) { return off.sideways <= kSideMargin; });
  });
}

// Returns the length in studs of the longest piece of the line that is not above any ground.
float longestOverNothing(const std::vector<Vec3>& line, const std::vector<Ground>& grounds) {
  float longest = 0, now = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 along = line[i + 1] - line[i];
    const int steps = 1 + int(length(along) / kStep);
    for (int k = 0; k < steps; ++k) {
      const Vec3 at = line[i] + along * (float(k) / float(steps));
      now = isOver(grounds, at) ? 0 : now + length(along) / float(steps);
      longest = std::max(longest, now);
    }
  }
  return longest;
}

class RouteTest : public ::testing::TestWithParam<std::string> {
 protected:
  // Calls `look` with levels of every difficulty and with default parameters.
  template <class Look>
  void forLevels(const Look& look) const {
    for (const gen::NamedNumber& d : gen::namedDifficulties()) {
      const gen::Generator generator = generatorOf(recipeFor(GetParam(), d.value));
      for (uint64_t seed = 0; seed < kRouteSeeds; ++seed) look(generator.generate(seed, 0));
    }
  }
};

// Parts are listed in the order in which they were built.
TEST_P(RouteTest, StandsOnTheCourseInItsOrder) {
  forLevels([](const gen::Generated& made) {
    const std::vector<Ground> grounds = groundsOf(made.sketch);
    const std::vector<Vec3>& line = made.sketch.line();
    size_t part = 0;
    for (size_t i = 0; i < line.size(); ++i) {
      while (part < grounds.size() && !standsOn(grounds[part], line[i])) ++part;
      ASSERT_LT(part, grounds.size()) << made.name << ", place " << i << ": " << line[i].x << ", "
                                      << line[i].y << ", " << line[i].z;
    }
  });
}

// A line that cuts a corner or runs between two routes would lead learners off the floor.
TEST_P(RouteTest, CrossesNoGapWiderThanAJump) {
  const float widest = generatorOf({}).reach().gap(0);
  forLevels([&](const gen::Generated& made) {
    const float limit = widest - kSideMargin;  // the margin does not count as floor at both ends
    EXPECT_LE(longestOverNothing(made.sketch.line(), groundsOf(made.sketch)), limit) << made.name;
  });
}

INSTANTIATE_TEST_SUITE_P(All, RouteTest, ::testing::ValuesIn(styleNames()), testName);

// A straight line would cut through the tower.
TEST(Truss, TheLineGoesUpTheTruss) {
  const gen::Generator generator = generatorOf(recipeFor("truss", 0.75f));
  for (uint64_t seed = 0; seed < kRouteSeeds; ++seed) {
    const gen::Generated made = generator.generate(seed, 0);
    const auto leadsBy = [&](Vec3 at) {
      const std::vector<Vec3>& line = made.sketch.line();
      return std::any_of(line.begin(), line.end(), [&](Vec3 v) { return length(v - at) < 1.5f; });
    };
    int trusses = 0;
    for (const gen::PartSketch& p : made.sketch.parts()) {
      if (p.shape != schema::Shape::TRUSS) continue;
      ++trusses;
      const Vec3 up{0, p.size.y / 2, 0};
      EXPECT_TRUE(leadsBy(p.position - up)) << made.name << ": the foot of " << p.name;
      EXPECT_TRUE(leadsBy(p.position + up)) << made.name << ": the top of " << p.name;
    }
    EXPECT_GT(trusses, 0) << made.name;
  }
}

}  // namespace
}  // namespace obby::test
