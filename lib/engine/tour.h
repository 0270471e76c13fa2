// One tour of touches: how it goes, and what is seen. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/report_bytes.h"

namespace obby::engine {

struct TourSeen {
  std::vector<Probe> touches, probes;
  Observation after;  // what goes on after a tour that does not settle
  double end = 0;     // of the tour, in seconds
  uint64_t used = 0;  // instructions
};

template <class A>
void fields(A& a, TourSeen& s) {
  a(s.touches), a(s.probes), a(s.end), a(s.used), a(s.after);
}

// `touches`: false lets the time of the touches pass without them. `settles`: false probes at once
// after them, while what lasts for seconds only goes on.
struct TourMode {
  bool patiently = true, touches = true, settles = true;
};

}  // namespace obby::engine
