// An interrupted fit ends soon with the best result so far, and says that it was interrupted. It
// reports its progress throughout.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "calibrate/course.h"
#include "calibrate/fit.h"
#include "calibrate/report.h"

namespace obby::calibrate {
namespace {

// Parameters of every kind: with gradients, counted in ticks, and deciding events or touches.
const std::vector<std::string> kOfAllKinds = {
    "walkSpeed", "gravity", "jumpSpeed", "landedTime", "floorAcquire", "coyoteTime", "bodyWidth"};

std::vector<Take> takesOfAnother() {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "walkSpeed", 18);
  setValue(truth.root().getParams(), "landedTime", 0.1);
  setValue(truth.root().getParams(), "floorAcquire", 1.05);
  // This manoeuvre alone determines as many of these parameters as all earlier manoeuvres of the
  // course together.
  return takesUnder(truth.reader().getParams(), 0.02f, manoeuvresNamed({"hold jump"}));
}

Fit interruptionFitted(const std::atomic<bool>& stop,
                       const std::function<void(const FitProgress&)>& progress, int threads = 2) {
  ThreadPool pool(threads);
  FitSettings settings;
  settings.restarts = 1;
  settings.generations = 2;
  auto out = fit(takesOfAnother(), *parametersNamed(kOfAllKinds, defaults()), defaults(), settings,
                 pool, stop, progress);
  EXPECT_TRUE(out) << out.error().text();
  return *std::move(out);
}

// A moment in a fit: this many evaluations after a task has completed this share.
struct When {
  std::string task;
  double share;
  uint64_t evaluations;
};

struct Stopped {
  FitProgress progress;  // progress when the fit stopped
  Fit fit;
};

Stopped stoppedAt(const When& when) {
  std::atomic<bool> stop{false};
  Stopped out;
  uint64_t begun = 0;
  out.fit = interruptionFitted(stop, [&](const FitProgress& progress) {
    if (stop || progress.task != when.task || progress.share < when.share) return;
    if (begun == 0) begun = progress.evaluations;
    if (progress.evaluations < begun + when.evaluations) return;
    out.progress = progress;
    stop = true;
  });
  EXPECT_TRUE(stop) << when.task << " was over sooner";
  return out;
}

class Interruption : public testing::TestWithParam<When> {};

TEST_P(Interruption, EndsAFitSoonWithTheBestSoFar) {
  const Stopped at = stoppedAt(GetParam());
  EXPECT_TRUE(at.fit.stopped);
  EXPECT_LT(at.fit.evaluations - at.progress.evaluations, 100u);
  EXPECT_LE(at.fit.loss, at.progress.loss * (1 + 1e-6));
  EXPECT_NE(textOf(at.fit, {}, 1, {}).find("interrupted"), std::string::npos);
}

// The last case stops among long windows. Their best value may differ from that of short windows.
INSTANTIATE_TEST_SUITE_P(Tasks, Interruption,
                         testing::Values(When{"searching", 0, 1}, When{"refining", 0, 100},
                                         When{"crossing", 0, 1}, When{"crossing", 0, 300},
                                         When{"crossing", 0.5, 100}, When{"crossing", 0.86, 100}),
                         [](const auto& named) {
                           return named.param.task + std::to_string(int(100 * named.param.share)) +
                                  "after" + std::to_string(named.param.evaluations);
                         });

// The fit has found all values, but only half of the trials for their intervals are done. It must
// not report these intervals.
TEST(Fit, LeavesUntriedIntervalsUnknown) {
  const Stopped at = stoppedAt({"weighing", 0, 40});
  EXPECT_TRUE(at.fit.stopped);
  EXPECT_LT(at.fit.evaluations - at.progress.evaluations, 100u);
  for (const Fitted& f : at.fit.parameters) {
    if (isDifferentiable(f.parameter.kind)) continue;
    EXPECT_EQ(f.low, f.parameter.lowest) << f.parameter.name;
    EXPECT_EQ(f.high, f.parameter.highest) << f.parameter.name;
  }
}

// A single thread reports after each of its tasks. More threads would make the number of
// evaluations between reports vary.
TEST(Fit, ReportsProgressContinuously) {
  const std::atomic<bool> stop{false};
  std::vector<FitProgress> reports;
  const Fit whole = interruptionFitted(
      stop, [&](const FitProgress& progress) { reports.push_back(progress); }, 1);
  EXPECT_FALSE(whole.stopped);
  EXPECT_EQ(textOf(whole, {}, 1, {}).find("interrupted"), std::string::npos);
  std::set<std::string> tasks;
  uint64_t longest = 0;
  for (size_t i = 1; i < reports.size(); ++i) {
    EXPECT_GE(reports[i].share, reports[i - 1].share);
    EXPECT_LE(reports[i].share, 1);
    longest = std::max(longest, reports[i].evaluations - reports[i - 1].evaluations);
    tasks.insert(reports[i].task);
  }
  EXPECT_EQ(tasks, (std::set<std::string>{"searching", "refining", "crossing", "weighing"}));
  EXPECT_LT(longest, whole.evaluations / 20) << "never silent for long";
}

}  // namespace
}  // namespace obby::calibrate
