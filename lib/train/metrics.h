// Metrics of training: the same names and values for all logs.
#pragma once

#include <string>
#include <vector>

#include "train/trainer.h"

namespace obby::train {

struct Metric {
  std::string name;
  double value;
  const char* unit;
  bool clock = false;  // depends on the clock, so equal runs differ
};

// Returns the metrics of an iteration. `seconds`: wall clock so far; `rate`: decisions per second.
std::vector<Metric> metricsOf(const Iteration& iteration, double seconds, double rate);

}  // namespace obby::train
