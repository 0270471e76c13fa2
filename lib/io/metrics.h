// Fills metrics records for every tool that writes them.
#pragma once

#include <cstdint>
#include <string>

#include "schema/obby.capnp.h"

namespace obby::io {

// `values` is a sized range whose elements have a name, a value and a unit ("" for a plain number).
template <class Values>
void setMetrics(schema::Metrics::Builder to, const std::string& source, uint64_t step,
                const Values& values) {
  to.setSource(source);
  to.setStep(step);
  auto list = to.initValues(uint32_t(values.size()));
  for (uint32_t i = 0; i < list.size(); ++i) {
    list[i].setName(values[i].name);
    list[i].setValue(values[i].value);
    list[i].setUnit(values[i].unit);
  }
}

}  // namespace obby::io
