// Finds the parameters under which the simulator does what the recordings show, and says what is
// known of each.
#pragma once

#include <span>
#include <vector>

#include "calibrate/findings.h"
#include "calibrate/fit_settings.h"
#include "calibrate/work.h"

namespace obby::calibrate {

struct Fit {
  std::vector<Fitted> parameters;
  std::vector<Tied> tied;
  double delay = 0;  // seconds from an input to what comes of it
  // As they were, or a run of the rules for every physics step, if that came nearer.
  uint32_t controlRate = 0, substeps = 0;
  double lossBefore = 0, loss = 0;
  uint64_t evaluations = 0;
  bool stopped = false;  // from outside: it is the best so far, and not all of it was judged
};

// `takes` must not be empty. `progress` is called from this thread, in all that takes long. A stop
// is heeded within some evaluations; what it costs, beside what was still to be done, is the
// intervals of what has no slope. Errors: what does not compile, and what the optimiser says.
Result<Fit> fit(std::span<const Take> takes, std::vector<Parameter> parameters,
                schema::PhysicsParams::Reader now, const FitSettings& settings, ThreadPool& pool,
                const std::atomic<bool>& stop,
                const std::function<void(const FitProgress&)>& progress);

}  // namespace obby::calibrate
