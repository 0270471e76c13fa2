// Metrics of training: the same names and values in all logs. Names are those of CleanRL and
// Stable-Baselines3, in camel case.
#pragma once

#include <string>
#include <vector>

#include "train/trainer.h"

namespace obby::train {

struct Metric {
  std::string name;
  double value;
  const char* unit;
};

// Returns the metrics of an iteration. `seconds`: wall clock so far; `rate`: decisions per second.
std::vector<Metric> metricsOf(const Iteration& iteration, double seconds, double rate);

}  // namespace obby::train
