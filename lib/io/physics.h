// Calibrated physics in a stream: a `params` record, as obby-calibrate writes it, applies to the
// levels after it.
#pragma once

#include <optional>

#include "io/record.h"

namespace obby::io {

// Sets the parameters that the level leaves at the simulator's defaults. A number that the level
// sets itself (such as its own walk speed) stays, so applying twice changes nothing.
void applyParams(schema::PhysicsParams::Reader params, schema::Level::Builder level);

class Physics {
 public:
  // Replaces the known parameters with those of the record.
  void know(Record params) { params_ = std::move(params); }
  bool known() const { return params_.has_value(); }

  // Both apply the known parameters to a level, as applyParams() does.
  Record applied(const Record& level) const;
  void apply(schema::Level::Builder level) const;

 private:
  std::optional<Record> params_;
};

}  // namespace obby::io
