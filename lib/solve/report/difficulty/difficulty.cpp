#include "solve/report/difficulty/difficulty.h"

#include <fmt/format.h>

#include <algorithm>

#include "solve/report/difficulty/clearance.h"
#include "solve/report/difficulty/press_windows.h"
#include "solve/report/difficulty/trials.h"

namespace obby::solve {

static_assert(int(Band::extreme) == int(schema::Band::EXTREME), "the order of schema Band");

namespace {

constexpr uint32_t kTogether = 128;  // trials per task

// A segment and its measurements.
struct Step {
  LastSegments rest;
  DifficultyStep found;
  std::vector<int32_t> shifts;   // ticks to the middle of each jump's press window
  std::vector<uint32_t> passed;  // number of passed trials of each task
};

// Measures windows, margin and clearance, which need no noise.
void measure(const Problem& problem, const NoiseModel& model, Step& step) {
  const Segment& s = step.rest.segment;
  const Course& course = step.rest.course;
  int32_t tightest = 0;
  for (const PressWindow& w : pressWindows(step.rest, model)) {
    tightest = step.shifts.empty() ? w.ticks() : std::min(tightest, w.ticks());
    step.shifts.push_back(w.middle());
  }
  step.found.window = float(tightest) * 1000 / float(problem.level.params.controlRate);
  if (s.to >= 0 && course.carriers[s.end() - 1] < 0) {
    step.found.margin = landingMargin(problem.level, course, s.end(), s.to);
  }
  step.found.clearance = killClearance(problem.level, course, s);
}

// Plays trials [first, last) of a step and returns how many passed.
uint32_t playTrials(const Step& step, size_t index, uint32_t first, uint32_t last,
                    const DifficultyOptions& options) {
  Trials trials(step.rest);
  const float spread = options.noise.place;
  for (uint32_t trial = first; trial < last; ++trial) {
    Random random(options.seed, uint64_t(index) << 32 | trial);
    const float x = spread * (2 * random.unit() - 1), z = spread * (2 * random.unit() - 1);
    trials.add(NoisyPlayer(step.rest, options.noise, step.shifts, random), {x, 0, z});
  }
  const std::vector<bool> passed = trials.run();
  return uint32_t(std::count(passed.begin(), passed.end(), true));
}

Difficulty summed(std::vector<Step> steps, uint32_t trials) {
  Difficulty d;
  d.trials = trials;
  float odds = 1;
  for (Step& step : steps) {
    DifficultyStep& found = step.found;
    for (const uint32_t passed : step.passed) found.passed += passed;
    found.success = float(found.passed) / float(trials);
    d.success *= found.success;
    odds *= std::max(float(found.passed), 0.5f) / float(trials);
    d.steps.push_back(found);
    if (harder(found, d.steps[d.hardest])) d.hardest = uint32_t(d.steps.size()) - 1;
  }
  d.expectedAttempts = odds * kMaxAttempts > 1 ? 1 / odds : kMaxAttempts;
  return d;
}

}  // namespace

std::string describe(const NoiseModel& m) {
  return fmt::format(
      "{}: press error {:.0f} ms, aim error {:g} degrees, reaction time {:.0f} ms, position error "
      "{:g} studs; assumed, not measured",
      m.name, m.press * 1000, m.aim, m.reaction * 1000, m.place);
}

Band bandOf(float success) {
  constexpr float kMin[] = {0.99f, 0.9f, 0.6f, 0.2f};
  int band = 0;
  for (const float min : kMin) band += success < min ? 1 : 0;
  return Band(band);
}

bool harder(const DifficultyStep& a, const DifficultyStep& b) {
  if (a.passed != b.passed) return a.passed < b.passed;
  return a.segment.jumps > 0 && (b.segment.jumps == 0 || a.window < b.window);
}

Difficulty difficultyOf(const Problem& problem, const Course& course,
                        const DifficultyOptions& options, ThreadPool& pool) {
  const std::vector<Segment> segments = segmentsOf(course);
  const uint32_t tasks = (options.trials + kTogether - 1) / kTogether;
  std::vector<Step> steps;
  for (size_t i = 0; i < segments.size(); ++i) {
    steps.push_back({LastSegments(problem, course, std::span(segments).subspan(i)),
                     {segments[i]},
                     {},
                     std::vector<uint32_t>(tasks)});
  }
  const auto givenUp = [&] { return options.stop != nullptr && *options.stop; };
  pool.run(int(steps.size()), [&](int i) {
    if (!givenUp()) measure(problem, options.noise, steps[size_t(i)]);
  });
  pool.run(int(steps.size() * tasks), [&](int n) {
    if (givenUp()) return;
    const size_t step = size_t(n) / tasks;
    const uint32_t task = uint32_t(n) % tasks, first = task * kTogether;
    steps[step].passed[task] =
        playTrials(steps[step], step, first, std::min(first + kTogether, options.trials), options);
  });
  return summed(std::move(steps), options.trials);
}

}  // namespace obby::solve
