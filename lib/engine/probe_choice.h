// Decides which parts are probed if there are too many to probe all. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/report.h"

namespace obby::engine {

constexpr const char* kTooManyParts = "the place has too many parts to test the touch of each";

struct Choice {
  std::vector<Probe> probes;
  std::vector<SameListeners> same;  // the others; their indices refer to `probes`
  bool isAll = true;                // false if some parts are in neither list
};

// Keeps the first part of each set of listeners, then the second of each, and so on, in order.
Choice choose(std::vector<Probe> wanted, size_t max);

}  // namespace obby::engine
