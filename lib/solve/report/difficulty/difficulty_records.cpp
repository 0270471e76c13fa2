#include "solve/report/difficulty/difficulty_records.h"

#include <fmt/format.h>

#include "solve/report/difficulty/press_windows.h"
#include "solve/report/part_text.h"

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

std::string hardestText(const Difficulty& difficulty, const level::Level& level,
                        schema::Level::Reader record) {
  const DifficultyStep& step = difficulty.steps[difficulty.hardest];
  const Segment& s = step.segment;
  const auto place = [&](int32_t part, const char* none) {
    return part < 0 ? std::string(none) : partText(record, uint32_t(part));
  };
  const Band band = bandOf(step.success);
  std::string text =
      fmt::format("The hardest step is the {} from {} to {} ({}{}", s.jumps > 0 ? "jump" : "move",
                  place(s.from, "the start"), place(s.to, "the goal"),
                  band <= Band::easy ? "still " : "", bandName(band));
  // A window as wide as the searched range means that the press need not be timed.
  const float widest = float(2 * kMaxShift) * 1000 / float(level.view().params.controlRate);
  if (s.jumps > 0 && step.window <= widest) {
    text += step.window > 0 ? fmt::format(": its time window is {:.2f} s", step.window / 1000)
                            : std::string(": a jump with no time to spare");
  }
  return text + ").";
}

}  // namespace obby::solve
