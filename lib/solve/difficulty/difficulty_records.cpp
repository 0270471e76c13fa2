#include "solve/difficulty/difficulty_records.h"

#include <fmt/format.h>

#include "solve/difficulty/press_windows.h"

namespace obby::solve {

namespace {

void fillStep(schema::DifficultyStep::Builder record, const DifficultyStep& step) {
  record.setStartTick(step.segment.start);
  record.setTicks(step.segment.ticks);
  record.setFrom(step.segment.from);
  record.setTo(step.segment.to);
  record.setJumps(step.segment.jumps);
  record.setBand(schema::Band(bandOf(step.success)));
  record.setSuccess(step.success);
  record.setWindow(step.window);
  record.setMargin(step.margin);
  record.setClearance(step.clearance);
}

const char* bandName(Band band) {
  constexpr const char* kNames[] = {"trivial", "easy", "medium", "hard", "extreme"};
  return kNames[size_t(band)];
}

std::string partText(int32_t part, const level::Level& level, const char* none) {
  return part < 0 ? std::string(none)
                  : fmt::format("part {} '{}'", part, level.partName(uint32_t(part)));
}

}  // namespace

void fillDifficulty(schema::Difficulty::Builder record, const Difficulty& difficulty,
                    const NoiseModel& noise) {
  const DifficultyStep& hardest = difficulty.steps[difficulty.hardest];
  record.setBand(schema::Band(bandOf(hardest.success)));
  record.setSuccess(difficulty.success);
  record.setExpectedAttempts(difficulty.expectedAttempts);
  record.setHardest(difficulty.hardest);
  auto steps = record.initSteps(uint32_t(difficulty.steps.size()));
  for (uint32_t i = 0; i < steps.size(); ++i) fillStep(steps[i], difficulty.steps[i]);
  record.setTrials(difficulty.trials);
  record.setNoise(describe(noise));
}

std::string hardestText(const Difficulty& difficulty, const level::Level& level) {
  const DifficultyStep& step = difficulty.steps[difficulty.hardest];
  const Segment& s = step.segment;
  std::string text = fmt::format("the {} from {} to {} ({}", s.jumps > 0 ? "jump" : "way",
                                 partText(s.from, level, "the start"),
                                 partText(s.to, level, "the goal"), bandName(bandOf(step.success)));
  // A window as wide as what is looked at says that the press need not be timed.
  const float widest = float(2 * kMostShift) * 1000 / float(level.view().params.controlRate);
  if (s.jumps > 0 && step.window <= widest) {
    text += fmt::format(", window {:.0f} ms", step.window);
  }
  return text + ")";
}

}  // namespace obby::solve
