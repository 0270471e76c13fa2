// Fits the parameters under which the simulator reproduces the recordings, and reports how well
// each is known.
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
  double delay = 0;  // seconds from an input to its effect
  // The original rates, or one control step per physics step if that fits better.
  uint32_t controlRate = 0, substeps = 0;
  double lossBefore = 0, loss = 0;
  uint64_t evaluations = 0;
  bool stopped = false;  // interrupted: the fit is the best so far, and some parameters were not
                         // examined
};

// `takes` must not be empty. `progress` is called on this thread. A stop takes effect within a few
// evaluations. The fit then skips the remaining work and the intervals of parameters without a
// gradient. Errors: those of Level::compile and of the optimiser.
Result<Fit> fit(std::span<const Take> takes, std::vector<Parameter> parameters,
                schema::PhysicsParams::Reader now, const FitSettings& settings, ThreadPool& pool,
                const std::atomic<bool>& stop,
                const std::function<void(const FitProgress&)>& progress);

}  // namespace obby::calibrate
