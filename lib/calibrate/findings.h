// What recordings tell of each parameter, at the point that a fit has found.
#pragma once

#include <string>
#include <vector>

#include "calibrate/objective.h"
#include "calibrate/work.h"

namespace obby::calibrate {

// What the recordings say of a parameter.
struct Fitted {
  Parameter parameter;
  double value = 0;
  double low = 0, high = 0;  // 95 % interval, within the bounds; the bounds: nothing is known
  bool known = false;        // the interval is narrow enough to be of use
  double before = 0;         // what it was
  double tick = 0;  // seconds, where it counts in whole ticks and something is known; else 0
};

// Two parameters of which the recordings know a combination only.
struct Tied {
  std::string one, other;
  double correlation = 0;
};

struct Findings {
  std::vector<Fitted> parameters;
  std::vector<Tied> tied;
};

// `asked`: those of the objective and others, which show nowhere. `before`, `found`: all parameters
// as they were, and at the point. After a stop nothing more is tried of those without a slope, and
// nothing is said of them. Errors as of Level::compile.
Result<Findings> findingsOf(const Objective& objective, const std::vector<double>& point,
                            const std::vector<Parameter>& asked,
                            schema::PhysicsParams::Reader before,
                            schema::PhysicsParams::Reader found, const Work& work);

// Half of an interval, in shares of the bounds, that is all that was known before.
constexpr double kNothing = 0.5;

}  // namespace obby::calibrate
