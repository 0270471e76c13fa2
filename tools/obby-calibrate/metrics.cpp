#include "metrics.h"

#include "io/metrics.h"

namespace obby::tools {

Status writeMetrics(io::Pipeline& pipeline, const std::string& source, uint64_t step,
                    const std::vector<Metric>& values) {
  io::RecordBuilder record;
  io::setMetrics(record.root().initMetrics(), source, step, values);
  return pipeline.write(record.reader());
}

}  // namespace obby::tools
