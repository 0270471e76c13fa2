// Estimates of the parameters from recordings, at the fitted point.
#pragma once

#include <string>
#include <vector>

#include "calibrate/objective.h"
#include "calibrate/work.h"

namespace obby::calibrate {

// Estimate of one parameter.
struct Fitted {
  Parameter parameter;
  double value = 0;
  double low = 0, high = 0;  // 95 % interval within the bounds; equal to the bounds if nothing is
                             // known
  bool known = false;        // the interval is narrow enough to be useful
  double before = 0;         // value before the fit
  double tick = 0;           // seconds, for a known parameter that counts in whole ticks; else 0
};

// Two parameters of which only a combination is identifiable.
struct Tied {
  std::string one, other;
  double correlation = 0;
};

struct Findings {
  std::vector<Fitted> parameters;
  std::vector<Tied> tied;
};

// `asked` holds the objective's parameters and others that have no effect. `before` and `found`
// hold all parameters before the fit and at the point. After a stop, parameters without a gradient
// are not examined and nothing is reported about them. Errors: those of Level::compile.
Result<Findings> findingsOf(const Objective& objective, const std::vector<double>& point,
                            const std::vector<Parameter>& asked,
                            schema::PhysicsParams::Reader before,
                            schema::PhysicsParams::Reader found, const Work& work);

// Half width of an interval that covers the bounds, in shares of them.
constexpr double kNothing = 0.5;

}  // namespace obby::calibrate
