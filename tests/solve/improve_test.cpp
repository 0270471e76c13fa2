// The improvement of solutions: what it must keep, and what it must find.
#include "solve/improve/improve.h"

#include <gtest/gtest.h>

#include "hand_played.h"
#include "solve/improve/line.h"
#include "solve/improve/press_risk.h"
#include "untimed.h"

namespace obby::solve {
namespace {

constexpr uint64_t kSteps = 200'000;

const Preference& preferenceOf(const char* name) { return *findPreference(name); }

Trajectory play(const Problem& problem, const std::vector<sim::Action>& actions) {
  const CostMeter meter(problem, preferenceOf("natural").weights, problem.bounds);
  return trajectoryOf(playLine(problem, actions, meter));
}

uint32_t missedPresses(const Problem& problem, const Trajectory& p) {
  const CostMeter meter(problem, preferenceOf("natural").weights, problem.bounds);
  return PressRisk(problem).missed(playLine(problem, actionsOf(p), meter));
}

double costOf(const Problem& problem, const Trajectory& p, const char* preference) {
  const CostWeights& weights = preferenceOf(preference).weights;
  const CostMeter meter(problem, weights, problem.bounds);
  const double risk = double(weights.press) * missedPresses(problem, p);
  return playLine(problem, actionsOf(p), meter).cost() + risk;
}

// A floor 80 studs long with the goal at its end. The player could just walk.
struct LongFloor {
  LongFloor() : level(build().compile()), asked(level) {
    asked.query.goal = boxAt({0, 2, -70}, {8, 4, 4});
    problem = asked.problem();
  }
  static LevelBuilder build() {
    LevelBuilder b;
    b.block({0, -0.5f, -36}, {40, 1, 80});
    b.spawn({0, 0, -2});
    return b;
  }

  // Walks in zigzag and jumps all the time.
  Trajectory zigzag() const {
    std::vector<sim::Action> actions;
    for (int t = 0; t < 1000; ++t) {
      const Turns heading = (t / 30) % 2 == 0 ? 8000 : 65536 - 8000;
      actions.push_back({heading, true, t % 50 < 3});
    }
    return play(problem, actions);
  }

  level::Level level;
  PlainQuery asked;
  Problem problem;
};

ImproveTask taskFor(const Problem& problem, const char* preference) {
  return {problem, preferenceOf(preference), kSteps, 1, [](const Trajectory&) { return true; }, {}};
}

TEST(Preferences, AreFoundByName) {
  EXPECT_STREQ(preferences().front().name, "natural");
  for (const Preference& p : preferences()) EXPECT_EQ(findPreference(p.name), &p);
  EXPECT_EQ(findPreference("first"), nullptr);
}

TEST(Cost, OfAWalkIsItsTimeAndOneKey) {
  const LongFloor floor;
  const Trajectory walk = play(floor.problem, std::vector<sim::Action>(400, {0, true, false}));
  ASSERT_EQ(walk.end.outcome, sim::Outcome::goal);
  const CostWeights& w = preferenceOf("natural").weights;
  EXPECT_NEAR(costOf(floor.problem, walk, "natural"), walk.ticks / 60.0 + double(w.change), 1e-6);
}

TEST(Cost, OfAJumpIsItsPriceAndItsKey) {
  const LongFloor floor;
  std::vector<sim::Action> actions(400, {0, true, false});
  const Trajectory walk = play(floor.problem, actions);
  actions[30].jump = true;
  const Trajectory jump = play(floor.problem, actions);
  ASSERT_EQ(jump.end.jumps, 1);
  const CostWeights& w = preferenceOf("few-jumps").weights;
  const double longer = (double(jump.ticks) - double(walk.ticks)) / 60.0;
  EXPECT_NEAR(costOf(floor.problem, jump, "few-jumps") - costOf(floor.problem, walk, "few-jumps"),
              longer + double(w.jump + w.change), 1e-5);
}

TEST(Cost, OfAPassNearAKillPartFallsWithDistance) {
  double last = 1e9;
  for (const float x : {3.5f, 4.0f, 5.0f, 9.0f}) {
    LevelBuilder b = LongFloor::build();
    b.block({x, 2, -30}, {2, 4, 20}, [](schema::Part::Builder p) { p.initKill().setDamage(100); });
    const level::Level level = b.compile();
    PlainQuery asked(level);
    asked.query.goal = boxAt({0, 2, -70}, {8, 4, 4});
    const Problem problem = asked.problem();
    const Trajectory walk = play(problem, std::vector<sim::Action>(400, {0, true, false}));
    ASSERT_EQ(walk.end.outcome, sim::Outcome::goal) << x;
    const double cost = costOf(problem, walk, "safe");
    EXPECT_TRUE(x > 5 ? cost <= last : cost < last) << x;
    last = cost;
  }
}

uint32_t missedPresses(const GapScene& scene, float pressAt) {
  return missedPresses(scene.problem, play(scene.problem, scene.jumpAt(pressAt).actions));
}

TEST(PressRisk, CountsPressesThatMissTheLanding) {
  EXPECT_EQ(missedPresses(GapScene(4), -6), 0u) << "a short gap, pressed early";
  EXPECT_EQ(missedPresses(GapScene(4), -8), 2u) << "late presses come after the edge";
  EXPECT_GE(missedPresses(GapScene(10.5f), -7.9f), 3u) << "a wide gap needs the last moment";
}

TEST(Improve, PrefersAJumpThatCanBePressedLate) {
  const GapScene scene(6);
  const Trajectory late = play(scene.problem, scene.jumpAt(-8).actions);
  ASSERT_EQ(late.end.outcome, sim::Outcome::goal);
  const Improved better = improve(taskFor(scene.problem, "natural"), late);
  EXPECT_LT(missedPresses(scene.problem, better.trajectory), missedPresses(scene.problem, late));
}

TEST(Improve, WalksStraightWhereThatIsPossible) {
  const LongFloor floor;
  const Trajectory zigzag = floor.zigzag();
  ASSERT_EQ(zigzag.end.outcome, sim::Outcome::goal);
  ASSERT_GT(zigzag.end.jumps, 3);
  const Improved better = improve(taskFor(floor.problem, "natural"), zigzag);
  EXPECT_EQ(better.trajectory.end.outcome, sim::Outcome::goal);
  EXPECT_EQ(better.trajectory.end.jumps, 0);
  EXPECT_LE(better.trajectory.actions.size(), 3u);
  const Trajectory walk = play(floor.problem, std::vector<sim::Action>(400, {0, true, false}));
  EXPECT_LE(better.trajectory.ticks, walk.ticks + 3);
}

TEST(Improve, IsNeverDearerAndReplays) {
  const GapScene scene(8);
  const Course course = scene.jumpAt(-7);
  const Trajectory first = play(scene.problem, course.actions);
  for (const Preference& p : preferences()) {
    const Improved better = improve(taskFor(scene.problem, p.name), first);
    EXPECT_LE(better.cost, costOf(scene.problem, first, p.name)) << p.name;
    const Trajectory again = play(scene.problem, actionsOf(better.trajectory));
    EXPECT_EQ(sim::stateHash(again.end), sim::stateHash(better.trajectory.end)) << p.name;
    EXPECT_EQ(again.end.outcome, sim::Outcome::goal) << p.name;
    EXPECT_EQ(again.end.jumps, 1) << p.name << ": the gap cannot be walked";
  }
}

TEST(Improve, KeepsWhatIsNotAccepted) {
  const LongFloor floor;
  const Trajectory zigzag = floor.zigzag();
  ImproveTask task = taskFor(floor.problem, "natural");
  task.accept = [](const Trajectory&) { return false; };
  EXPECT_EQ(improve(task, zigzag).trajectory.ticks, zigzag.ticks);
}

TEST(Improve, StopsAtItsBudget) {
  const LongFloor floor;
  ImproveTask task = taskFor(floor.problem, "natural");
  task.steps = 30'000;
  EXPECT_LE(improve(task, floor.zigzag()).steps, 2 * task.steps);
  task.stop = [] { return true; };
  EXPECT_LE(improve(task, floor.zigzag()).steps, 20'000u);
}

FilterOptions improving(const char* preference, int threads) {
  FilterOptions options;
  options.threads = threads;
  options.solver.preference = findPreference(preference);
  options.solver.improveSteps = 100'000;
  return options;
}

TEST(Improve, AnswersDoNotDependOnThreads) {
  const LinesFile file(stonesText());
  FilterOptions one = improving("natural", 1), three = improving("natural", 3);
  one.solver.progressRecords = three.solver.progressRecords = false;
  const Filtered a = runFilter(file.path(), one), b = runFilter(file.path(), three);
  ASSERT_TRUE(a.status) << a.status.error().text();
  EXPECT_EQ(withoutTiming(a.output), withoutTiming(b.output));
}

TEST(Improve, TheFirstSolutionIsShownBefore) {
  const LinesFile file(stonesText());
  const Filtered shown = runFilter(file.path(), improving("natural", 1));
  ASSERT_TRUE(shown.status) << shown.status.error().text();
  const size_t first = shown.output.find("\"solution\":");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(shown.output.find("\"solution\":", first + 1), std::string::npos) << "once";
  EXPECT_LT(first, shown.output.find("\"type\":\"trajectory\""));
  FilterOptions asFound = improving("natural", 1);
  asFound.solver.preference = nullptr;
  EXPECT_EQ(runFilter(file.path(), asFound).output.find("\"solution\":"), std::string::npos);
}

TEST(Improve, SeveralSolutionsStayDistinct) {
  const LinesFile file(stonesText());
  for (const uint32_t count : {2u, 3u, 4u, 5u, 6u}) {
    FilterOptions options = improving("natural", 1);
    options.solver.budget.solutions = count;
    options.solver.progressRecords = false;
    const Filtered found = runFilter(file.path(), options);
    ASSERT_TRUE(found.status) << found.status.error().text();
    EXPECT_NE(found.output.find("\"solutions\":" + std::to_string(count)), std::string::npos)
        << found.output;
  }
}

}  // namespace
}  // namespace obby::solve
