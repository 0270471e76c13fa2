#include "metrics.h"

namespace obby::tools {

Status writeMetrics(io::Pipeline& pipeline, const std::string& source, uint64_t step,
                    const std::vector<Metric>& values) {
  io::RecordBuilder record;
  auto metrics = record.root().initMetrics();
  metrics.setSource(source);
  metrics.setStep(step);
  auto list = metrics.initValues(uint32_t(values.size()));
  for (uint32_t i = 0; i < list.size(); ++i) {
    list[i].setName(values[i].name);
    list[i].setValue(values[i].value);
    list[i].setUnit(values[i].unit);
  }
  return pipeline.write(record.reader());
}

}  // namespace obby::tools
