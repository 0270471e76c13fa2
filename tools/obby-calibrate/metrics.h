// One metrics record of obby-calibrate's output.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/pipeline.h"

namespace obby::tools {

struct Metric {
  std::string name;
  double value;
  std::string unit;  // empty: a plain number
};

Status writeMetrics(io::Pipeline& pipeline, const std::string& source, uint64_t step,
                    const std::vector<Metric>& values);

}  // namespace obby::tools
