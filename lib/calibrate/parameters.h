// The physics parameters that recordings can determine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::calibrate {

struct Parameter {
  std::string name;        // as in PhysicsParams
  std::string unit;        // from the schema
  double lowest, highest;  // range searched; shares are linear if `lowest` is 0
  std::string manoeuvre;   // a recording that determines it
  enum class Kind {
    smooth,  // errors have a gradient with respect to it
    ticks,   // a time that the simulator counts in whole ticks
    event,   // only decides the moment of an event
    touch,   // errors have a gradient, but jump when it changes what is touched
  };
  Kind kind = Kind::smooth;
};

constexpr bool isDifferentiable(Parameter::Kind kind) {
  return kind == Parameter::Kind::smooth || kind == Parameter::Kind::touch;
}

// Returns all parameters that can be fitted, with bounds around `now` within the schema's ranges.
std::vector<Parameter> parametersAround(schema::PhysicsParams::Reader now);

// Returns the named parameters in the order of the list above, each once. The error lists the valid
// names.
Result<std::vector<Parameter>> parametersNamed(const std::vector<std::string>& names,
                                               schema::PhysicsParams::Reader now);

double valueOf(schema::PhysicsParams::Reader params, std::string_view name);
void setValue(schema::PhysicsParams::Builder params, std::string_view name, double value);

// Sets a value from user input. Errors: no such parameter, out of range.
Status setNamed(schema::PhysicsParams::Builder params, const std::string& name, double value);

// The share is the optimiser's coordinate: 0 and 1 are the bounds. The scale between them is
// logarithmic, or linear if the lower bound is 0. Values beyond a bound are clamped to it.
double shareOf(const Parameter& parameter, double value);
double valueAt(const Parameter& parameter, double share);

}  // namespace obby::calibrate
