// Options and observations of one tour of touches. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/report_bytes.h"

namespace obby::engine {

struct TourSeen {
  std::vector<Probe> touches, probes;
  Observation after;  // changes that go on after a tour that does not settle
  double end = 0;     // end of the tour, in seconds
  uint64_t used = 0;  // instructions used
};

template <class A>
void fields(A& a, TourSeen& s) {
  a(s.touches), a(s.probes), a(s.end), a(s.used), a(s.after);
}

// If `touches` is false, the time of the touches passes without them. If `settles` is false, the
// probes start right after the touches, during their lasting effects.
struct TourMode {
  bool patiently = true, touches = true, settles = true;
};

}  // namespace obby::engine
