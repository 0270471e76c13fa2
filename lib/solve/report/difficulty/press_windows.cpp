#include "solve/report/difficulty/press_windows.h"

#include "solve/report/difficulty/trials.h"

namespace obby::solve {

std::vector<PressWindow> pressWindows(const LastSegments& rest, const NoiseModel& model) {
  std::vector<int32_t> shifts(rest.jumps.size(), 0);
  std::vector<PressWindow> windows(rest.jumps.size());
  for (size_t jump = 0; jump < windows.size(); ++jump) {
    Trials trials(rest);
    for (int32_t shift = -kMaxShift; shift <= kMaxShift; ++shift) {
      shifts[jump] = shift;
      trials.add(NoisyPlayer(rest, model, shifts));
    }
    const std::vector<bool> passed = trials.run();
    PressWindow& w = windows[jump];
    if (passed[kMaxShift]) w = {0, 0};
    while (w.min <= w.max && w.min > -kMaxShift && passed[size_t(kMaxShift + w.min - 1)]) {
      --w.min;
    }
    while (w.min <= w.max && w.max < kMaxShift && passed[size_t(kMaxShift + w.max + 1)]) {
      ++w.max;
    }
    shifts[jump] = w.middle();
  }
  return windows;
}

}  // namespace obby::solve
