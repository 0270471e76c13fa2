// Calibrated physics in a stream: a `params` record, as obby-calibrate writes it, holds for the
// levels behind it.
#pragma once

#include <optional>

#include "io/record.h"

namespace obby::io {

// Puts the parameters where the level leaves the simulator's defaults. A number that it states
// otherwise (a place of its own walk speed) stays; so applying twice changes nothing.
void applyParams(schema::PhysicsParams::Reader params, schema::Level::Builder level);

class Physics {
 public:
  // The parameters of the record take the place of those that came before.
  void know(Record params) { params_ = std::move(params); }
  bool known() const { return params_.has_value(); }

  // The level with the known parameters, as applyParams() has it.
  Record applied(const Record& level) const;
  void apply(schema::Level::Builder level) const;

 private:
  std::optional<Record> params_;
};

}  // namespace obby::io
