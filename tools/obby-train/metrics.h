// What is said of learning as it goes: names, values and units, the same in every place they go to.
#pragma once

#include <span>
#include <vector>

#include "io/stream.h"
#include "train/trainer.h"

namespace obby::tools {

struct Metric {
  const char* name;
  double value;
  const char* unit;
};

// Of an iteration. `seconds`: wall clock so far; `rate`: decisions a second.
std::vector<Metric> metricsOf(const train::Iteration& iteration, double seconds, double rate);

// As a record, flushed.
Status writeMetrics(io::StreamWriter& output, const char* source, uint64_t step,
                    std::span<const Metric> values);

}  // namespace obby::tools
