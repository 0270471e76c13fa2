// Metrics as records of the output stream.
#pragma once

#include <span>

#include "io/stream.h"
#include "train/metrics.h"

namespace obby::tools {

// As a record, flushed.
Status writeMetrics(io::StreamWriter& output, const char* source, uint64_t step,
                    std::span<const train::Metric> values);

}  // namespace obby::tools
