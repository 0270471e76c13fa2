#include "calibrate/polish.h"

#include "calibrate/crossing.h"
#include "calibrate/evidence.h"
#include "calibrate/ticks.h"

namespace obby::calibrate {

namespace {

constexpr int kEventRounds = 3;
constexpr int kDelayRounds = 6;   // more rounds: accelerations change much with the delay
constexpr int kPolishRounds = 4;  // max rounds of gradient steps and tick counts

// Alternates gradient steps and tick counts while that helps.
Status refine(const Objective& objective, Found& found, const Work& work) {
  std::vector<double> point = found.in(objective);
  settle(objective, point, Tried::singly, work);
  for (int round = 0; round < kPolishRounds && !work.stopped(); ++round) {
    OBBY_ASSIGN(point, refined(objective, std::move(point), kGradientRounds, work));
    if (!settle(objective, point, Tried::singly, work)) break;
  }
  found.take(objective, point);
  return {};
}

void crossBy(const Objective& objective, size_t coordinate, const std::vector<double>& shares,
             int rounds, Found& found, const Work& work) {
  const Crossing crossing =
      crossingOf(objective, found.in(objective), coordinate, shares, rounds, work);
  found.take(objective, crossing.best);
}

void crossBy(const Objective& objective, size_t coordinate, Found& found, const Work& work) {
  const auto over = [&](const std::vector<double>& shares, int rounds) {
    if (!work.stopped()) crossBy(objective, coordinate, shares, rounds, found, work);
  };
  switch (objective.parameters()[coordinate].kind) {
    case Parameter::Kind::smooth: return;
    case Parameter::Kind::ticks:
      return over(countsAround(objective, found.in(objective), coordinate), kGradientRounds);
    case Parameter::Kind::event:
    case Parameter::Kind::touch:
      over(sharesAllOver(), kEventRounds);
      over(sharesAround(found.in(objective)[coordinate]), kEventRounds);
  }
}

void cross(const Objective& objective, Found& found, const Work& work) {
  const size_t count = objective.parameters().size();
  crossBy(objective, count, delaysAround(objective, found.in(objective)[count]), kDelayRounds,
          found, work);
  for (size_t i = 0; i < count && !work.stopped(); ++i) {
    work.account().step(i + 1, count + 2);
    crossBy(objective, i, found, work);
  }
  work.account().step(count + 1, count + 2);
  std::vector<double> point = found.in(objective);
  settle(objective, point, Tried::inPairs, work);
  found.take(objective, point);
}

}  // namespace

Status polish(const Objective& objective, Found& found, const Work& work, Stretch stretch) {
  work.account().enter("refining", stretch.of(0, 0.2));
  OBBY_RETURN_IF_ERROR(refine(objective, found, work));
  if (work.stopped()) return {};
  work.account().enter("crossing", stretch.of(0.2, 0.9));
  cross(objective, found, work);
  if (work.stopped()) return {};
  work.account().enter("refining", stretch.of(0.9, 1));
  return refine(objective, found, work);
}

}  // namespace obby::calibrate
