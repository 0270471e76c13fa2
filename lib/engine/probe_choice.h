// Which parts are probed where there are too many for all. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/report.h"

namespace obby::engine {

constexpr const char* kTooManyParts = "too many parts to touch";

struct Choice {
  std::vector<Probe> probes;
  std::vector<SameListeners> same;  // the others; their indices are those of `probes`
  bool isAll = true;                // false: some parts are in neither list
};

// Keeps the first part of each set of listeners, then the second of each, and so on, in order.
Choice choose(std::vector<Probe> wanted, size_t most);

}  // namespace obby::engine
