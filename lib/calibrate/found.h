// The current result of a fit.
#pragma once

#include <vector>

#include "calibrate/objective.h"

namespace obby::calibrate {

// A value for each parameter, and the delay.
struct Found {
  io::RecordBuilder values;
  double delay = 0;

  Found copy() const { return {io::RecordBuilder(values.reader()), delay}; }
  schema::PhysicsParams::Reader params() const { return values.reader().getParams(); }
  std::vector<double> in(const Objective& objective) const {
    return objective.pointAt(params(), delay);
  }
  void take(const Objective& objective, const std::vector<double>& point) {
    objective.apply(point, values.root().getParams());
    delay = objective.delayAt(point);
  }
  // Sets the control steps per second and the physics steps in each.
  void setRate(uint32_t controlRate, uint32_t substeps) {
    values.root().getParams().setControlRate(uint16_t(controlRate));
    values.root().getParams().setSubsteps(uint16_t(substeps));
  }
};

}  // namespace obby::calibrate
