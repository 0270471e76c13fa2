#include "solve/report/difficulty/difficulty.h"

#include <gtest/gtest.h>

#include "hand_played.h"
#include "solve/report/difficulty/clearance.h"
#include "solve/report/difficulty/difficulty_records.h"
#include "solve/report/difficulty/press_windows.h"
#include "solve/report/difficulty/trials.h"

namespace obby::solve {
namespace {

Difficulty measured(const Problem& problem, const Course& course, uint32_t trials = 300,
                    int threads = 1, uint64_t seed = 1) {
  ThreadPool pool(threads);
  EXPECT_EQ(course.replay.worlds.back().outcome, sim::Outcome::goal);
  return difficultyOf(problem, course, {trials, seed, {}}, pool);
}

Difficulty ofGap(float gap, float pressAt) {
  const GapScene scene(gap);
  return measured(scene.problem, scene.jumpAt(pressAt));
}

// Returns the difficulty of a walk of 24 studs over a beam of this width, between two platforms.
Difficulty ofBeam(float width, const std::function<void(LevelBuilder&)>& more = {}) {
  LevelBuilder b = GapScene::build(24, 8);
  b.block({0, -0.5f, -20}, {width, 1, 24});
  if (more) more(b);
  const level::Level level = b.compile();
  PlainQuery asked(level);
  Problem problem = asked.problem();
  problem.query.goal = boxAt({0, 2, -38}, {8, 4, 2});
  return measured(problem, courseOf(problem, playByHand(problem, walkAndJump(1e3f, 1e3f))));
}

TEST(Noise, TextStatesItsNumbers) {
  const std::string text = describe({});
  for (const char* part : {"average player", "30 ms", "6 degrees", "250 ms", "0.2 studs"}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

TEST(NoisyPlayer, RepeatsTheRecordingWithoutNoise) {
  const GapScene scene(7);
  const Course course = scene.jumpAt(-7);
  const std::vector<Segment> segments = segmentsOf(course);
  const LastSegments rest(scene.problem, course, segments);
  NoisyPlayer player(rest, {}, {});
  sim::World w = course.at(0);
  for (uint32_t t = 0; t < segments[0].end(); ++t) {
    sim::advance(w, nullptr, scene.problem.level, &scene.problem.query, player.next(w));
    ASSERT_EQ(sim::stateHash(w), sim::stateHash(course.at(t + 1))) << t;
  }
}

TEST(NoisyPlayer, ReturnsToThePath) {
  // The player starts two studs next to the trajectory, makes no other errors, and returns to it.
  LevelBuilder b;
  b.block({0, -0.5f, -50}, {20, 1, 100});
  b.spawn({0, 0, -2});
  const level::Level level = b.compile();
  PlainQuery asked(level);
  Problem problem = asked.problem();
  problem.query.goal = boxAt({0, 2, -90}, {20, 4, 2});
  const Course course = courseOf(problem, playByHand(problem, walkAndJump(1e3f, 1e3f)));
  const std::vector<Segment> segments = segmentsOf(course);
  const LastSegments rest(problem, course, segments);
  NoisyPlayer player(rest, {}, {});
  sim::World w = course.at(0);
  w.position.x = 2;
  for (int t = 0; t < 120; ++t) {
    sim::advance(w, nullptr, problem.level, &problem.query, player.next(w));
  }
  EXPECT_NEAR(w.position.x, 0, 0.1f);
  EXPECT_LT(w.position.z, -25);
}

TEST(Difficulty, AWideWalkIsTrivial) {
  const Difficulty d = ofBeam(8);
  EXPECT_GE(d.success, 0.999f);
  EXPECT_LE(d.expectedAttempts, 1.01f);
  EXPECT_EQ(bandOf(d.steps[d.hardest].success), Band::trivial);
  for (const DifficultyStep& s : d.steps) EXPECT_EQ(s.window, 0);
}

TEST(Difficulty, WiderGapsAreHarder) {
  const Difficulty easy = ofGap(5, -7), wide = ofGap(9.5f, -9), limit = ofGap(11, -9.8f);
  EXPECT_GT(easy.success, 0.98f);
  EXPECT_LT(wide.success, easy.success);
  EXPECT_LT(limit.success, wide.success - 0.05f);
  EXPECT_GT(easy.steps[0].window, wide.steps[0].window);
  EXPECT_GT(wide.steps[0].window, limit.steps[0].window);
  EXPECT_GT(limit.steps[0].window, 0);
  EXPECT_GT(limit.expectedAttempts, 1.05f);
}

TEST(Difficulty, NarrowerBeamsAreHarder) {
  const Difficulty broad = ofBeam(3), narrow = ofBeam(1), edge = ofBeam(0.2f);
  EXPECT_GT(broad.success, narrow.success);
  EXPECT_GT(narrow.success, edge.success + 0.02f);
}

// The window lasts from the first position from which a jump reaches the far side to the last one
// where the player can still jump.
TEST(PressWindow, IsTheRunUpDividedByTheSpeed) {
  for (const float gap : {8.0f, 9.5f}) {
    const GapScene scene(gap);
    const Course course = scene.jumpAt(-8.6f);
    const std::vector<Segment> segments = segmentsOf(course);
    const std::vector<PressWindow> windows =
        pressWindows(LastSegments(scene.problem, course, segments), {});
    ASSERT_EQ(windows.size(), 1u);
    const Params& p = scene.problem.level.params;
    // The floor is sensed this far beyond its edge. A player whose feet are at most a hip height
    // below the top still gets up.
    const float toe = p.bodyDepth * p.floorRaySpread;
    const float seconds =
        (p.jumpSpeed + sqrtf32(p.jumpSpeed * p.jumpSpeed + 2 * p.gravity * p.hipHeight)) /
        p.gravity;
    const float first = -8 - gap + toe + p.walkSpeed * seconds;
    const float last = -8 - toe - p.walkSpeed * p.coyoteTime;
    const float ticks = (first - last) / p.walkSpeed * float(p.controlRate);
    EXPECT_NEAR(float(windows[0].ticks()), ticks, 2) << gap;
  }
}

TEST(PressWindow, ContainsTheRecordedPressAndTrialsAimAtItsMiddle) {
  const GapScene scene(8);
  // The key is pressed at the last moment. Most trials still pass, since players know when to
  // press.
  const Course late = scene.jumpAt(-9.8f);
  const std::vector<Segment> segments = segmentsOf(late);
  const PressWindow w = pressWindows(LastSegments(scene.problem, late, segments), {})[0];
  EXPECT_LE(w.max, 2);
  EXPECT_LT(w.middle(), -4);
  EXPECT_GT(measured(scene.problem, late).success, 0.95f);
}

TEST(Clearance, MarginIsTheDistanceToTheNearestEdge) {
  GapScene scene(5, 6);
  const Course course = scene.jumpAt(-7);
  const Segment s = segmentsOf(course)[0];
  const Vec3 feet = course.at(s.end()).position;
  const float expected = std::min({3 - std::abs(feet.x), -13 - feet.z, feet.z + 21});
  EXPECT_NEAR(landingMargin(scene.problem.level, course, s.end(), 1), expected, 1e-4f);
  EXPECT_GT(expected, 0.3f);
  const Difficulty d = measured(scene.problem, course);
  EXPECT_NEAR(d.steps[0].margin, expected, 1e-4f);
  EXPECT_EQ(d.steps[1].margin, 0);
}

schema::Part::Builder deadly(schema::Part::Builder p) {
  p.initKill();
  return p;
}

TEST(Clearance, ClearanceIsTheDistanceToTheNearestKillPart) {
  const auto wall = [](LevelBuilder& b) {
    b.block({6, 3, -20}, {2, 6, 24}, [](schema::Part::Builder p) { deadly(p); });
  };
  const auto ball = [](LevelBuilder& b) {
    b.block({-7, 3, -20}, {2, 2, 2},
            [](schema::Part::Builder p) { deadly(p).setShape(schema::Shape::BALL); });
  };
  // The arms are the body part that comes nearest to an edge of this block.
  const auto corner = [](LevelBuilder& b) {
    b.block({6, 8, -20}, {2, 2, 2}, [](schema::Part::Builder p) { deadly(p); });
  };
  const level::Level plain = GapScene::build(24, 8).compile();
  const Params& p = plain.view().params;
  const float arm = p.armSpan * 0.5f + p.touchMargin, armTop = p.headBottom + p.touchMargin;
  EXPECT_NEAR(ofBeam(8, wall).steps[1].clearance, 5 - arm, 0.1f);
  EXPECT_NEAR(ofBeam(8, ball).steps[1].clearance, 7 - 1 - arm, 0.1f);
  const float aside = 5 - arm, above = 7 - armTop;
  EXPECT_NEAR(ofBeam(8, corner).steps[1].clearance, sqrtf32(aside * aside + above * above), 0.1f);
  EXPECT_EQ(ofBeam(8).steps[1].clearance, -1);
}

TEST(Difficulty, KillPartsNextToThePathMakeItHarder) {
  const auto lava = [](float x) {
    return [x](LevelBuilder& b) {
      b.block({x, 3, -20}, {1, 6, 24}, [](schema::Part::Builder p) { deadly(p); });
    };
  };
  EXPECT_LT(ofBeam(8, lava(3)).success, ofBeam(8, lava(6)).success - 0.1f);
}

TEST(Difficulty, IsTheSameOnAnyNumberOfThreads) {
  const GapScene scene(10.5f);
  const Course course = scene.jumpAt(-9.5f);
  const Difficulty one = measured(scene.problem, course, 300, 1);
  const Difficulty three = measured(scene.problem, course, 300, 3);
  ASSERT_EQ(one.steps.size(), three.steps.size());
  for (size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_EQ(one.steps[i].passed, three.steps[i].passed);
    EXPECT_EQ(one.steps[i].window, three.steps[i].window);
  }
  EXPECT_LT(one.success, 1);
  const auto passed = [&](uint64_t seed) {
    return measured(scene.problem, course, 300, 1, seed).steps[0].passed;
  };
  EXPECT_FALSE(passed(2) == passed(3) && passed(3) == passed(4) && passed(4) == passed(5));
}

TEST(Difficulty, TrialsKeepToTheQuery) {
  const level::Level level = steppingStones().compile();
  PlainQuery asked(level);
  const auto keys = [](const sim::World& w) {
    const float z = w.position.z;
    return sim::Action{0, true, (z < -7 && z > -9) || (z < -19 && z > -21)};
  };
  const auto successOf = [&] {
    const Problem problem = asked.problem();
    return measured(problem, courseOf(problem, playByHand(problem, keys))).success;
  };
  const float free = successOf();
  EXPECT_GT(free, 0.98f);
  asked.avoid.push_back(boxAt({5.3f, 4, -16}, {10, 20, 8}));
  EXPECT_LT(successOf(), free - 0.05f);
  asked.avoid.clear();
  // Adds a narrow waypoint before the second stone.
  asked.waypoints.push_back({boxAt({0, 4, -12}, {0.5f, 20, 1})});
  EXPECT_LT(successOf(), free - 0.05f);
}

TEST(Difficulty, IncludesMovingPlatforms) {
  LevelBuilder b = steppingStones();
  constexpr float kSpeed = 3;  // studs/s along X, from the start of the motion
  b.block({-3, -0.5f, -40}, {6, 1, 8}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(true);
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {-6, -0.5f, -40});
    support::set(keys[1].initPosition(), {6, -0.5f, -40});
    keys[1].setTime(12 / kSpeed);
  });
  const level::Level level = b.compile();
  PlainQuery asked(level);
  Problem problem = asked.problem();
  problem.query.goal = boxAt({0, 2, -43}, {40, 6, 1});
  const Course course = courseOf(problem, playByHand(problem, [](const sim::World& w) {
                                   const float z = w.position.z;
                                   const bool edge = (z < -7 && z > -9) || (z < -19 && z > -21) ||
                                                     (z < -31 && z > -33);
                                   return sim::Action{0, true, edge};
                                 }));
  const Difficulty d = measured(problem, course);
  ASSERT_EQ(routeOf(course), (std::vector<int32_t>{0, 1, 2, 3}));
  const DifficultyStep& onto = d.steps[2];
  EXPECT_EQ(onto.segment.to, 3);
  EXPECT_GT(onto.success, 0.5f);
  const uint32_t tick = onto.segment.end();
  const Vec3 feet = course.at(tick).position;
  const float center = -6 + kSpeed * float(course.at(tick).tick) / 60;
  EXPECT_NEAR(onto.margin, std::min(3 - std::abs(feet.x - center), -36 - feet.z), 0.01f);
}

TEST(Difficulty, IsFiniteIfNoTrialPasses) {
  const GapScene scene(9.5f);
  const Course course = scene.jumpAt(-9);
  ThreadPool pool(1);
  NoiseModel wild;
  wild.press = 100;  // seconds
  const Difficulty d = difficultyOf(scene.problem, course, {20, 1, wild}, pool);
  EXPECT_EQ(d.success, 0);
  EXPECT_EQ(bandOf(d.steps[d.hardest].success), Band::extreme);
  EXPECT_FLOAT_EQ(d.expectedAttempts, 40);
}

// A window of zero is easiest for a step without a jump, and hardest for one with a jump.
TEST(Difficulty, AmongEqualTrialsTheTightestJumpIsHardest) {
  const auto step = [](uint32_t jumps, float window, uint32_t passed = 50) {
    DifficultyStep out;
    out.segment.jumps = jumps;
    out.window = window;
    out.passed = passed;
    return out;
  };
  const DifficultyStep trajectory = step(0, 0), wide = step(1, 300), tight = step(2, 50),
                       lost = step(1, 0);
  const DifficultyStep* const ascending[] = {&trajectory, &wide, &tight, &lost};
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(harder(*ascending[i], *ascending[k]), i > k) << i << k;
  }
  EXPECT_TRUE(harder(step(0, 0, 40), lost));
  EXPECT_FALSE(harder(lost, step(0, 0, 40)));
}

// The text is for designers: parts by name, and the time to press in seconds.
TEST(Difficulty, SaysWhichStepIsHardest) {
  LevelBuilder b = GapScene::build(5, 8);
  const level::Level level = b.compile();
  const auto textOf = [&](int32_t from, int32_t to, uint32_t jumps, float window) {
    Difficulty d;
    d.steps.emplace_back();
    d.steps[0].segment.from = from;
    d.steps[0].segment.to = to;
    d.steps[0].segment.jumps = jumps;
    d.steps[0].window = window;
    d.steps[0].success = 0.5f;
    return hardestText(d, level, b.record());
  };
  const std::string step = "The hardest step is the ";
  EXPECT_EQ(textOf(0, 1, 1, 66.7f),
            step + "jump from part 0 to part 1 (hard: its time window is 0.07 s).");
  EXPECT_EQ(textOf(0, -1, 1, 0),
            step + "jump from part 0 to the goal (hard: a jump with no time to spare).");
  EXPECT_EQ(textOf(-1, 1, 1, 1000), step + "jump from the start to part 1 (hard).")
      << "at any time";
  EXPECT_EQ(textOf(-1, 1, 0, 0), step + "move from the start to part 1 (hard).");
}

TEST(Difficulty, BandsAreOrdered) {
  EXPECT_EQ(bandOf(1), Band::trivial);
  EXPECT_EQ(bandOf(0.95f), Band::easy);
  EXPECT_EQ(bandOf(0.7f), Band::medium);
  EXPECT_EQ(bandOf(0.3f), Band::hard);
  EXPECT_EQ(bandOf(0), Band::extreme);
}

}  // namespace
}  // namespace obby::solve
