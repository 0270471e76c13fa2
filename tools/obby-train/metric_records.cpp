#include "metric_records.h"

namespace obby::tools {

Status writeMetrics(io::StreamWriter& output, const char* source, uint64_t step,
                    std::span<const train::Metric> values) {
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
  OBBY_RETURN_IF_ERROR(output.write(record.reader()));
  return output.flush();
}

}  // namespace obby::tools
