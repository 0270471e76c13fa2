// What is said of learning as it goes: the same names and values wherever they go to.
#pragma once

#include <string>
#include <vector>

#include "train/trainer.h"

namespace obby::train {

struct Metric {
  std::string name;
  double value;
  const char* unit;
  bool clock = false;  // differs between runs of the same
};

// Of an iteration. `seconds`: wall clock so far; `rate`: decisions a second.
std::vector<Metric> metricsOf(const Iteration& iteration, double seconds, double rate);

}  // namespace obby::train
