#include "solve/report/difficulty/press_windows.h"

#include "solve/report/difficulty/trials.h"

namespace obby::solve {

std::vector<PressWindow> pressWindows(const Leg& leg, const NoiseModel& model) {
  std::vector<int32_t> shifts(leg.jumps.size(), 0);
  std::vector<PressWindow> windows(leg.jumps.size());
  for (size_t jump = 0; jump < windows.size(); ++jump) {
    Trials trials(leg);
    for (int32_t shift = -kMostShift; shift <= kMostShift; ++shift) {
      shifts[jump] = shift;
      trials.add(NoisyPlayer(leg, model, shifts));
    }
    const std::vector<bool> passed = trials.run();
    PressWindow& w = windows[jump];
    if (passed[kMostShift]) w = {0, 0};
    while (w.least <= w.most && w.least > -kMostShift && passed[size_t(kMostShift + w.least - 1)]) {
      --w.least;
    }
    while (w.least <= w.most && w.most < kMostShift && passed[size_t(kMostShift + w.most + 1)]) {
      ++w.most;
    }
    shifts[jump] = w.middle();
  }
  return windows;
}

}  // namespace obby::solve
