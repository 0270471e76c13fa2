// The physics parameters that a recording can tell something about.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::calibrate {

struct Parameter {
  std::string name;        // of PhysicsParams
  std::string unit;        // of the schema
  double lowest, highest;  // that are tried; from a lowest of 0 on shares are no logarithms
  std::string manoeuvre;   // what to record to learn of it
  enum class Kind {
    smooth,  // errors have a slope by it
    ticks,   // a time that the simulator counts in whole ticks
    event,   // decides when something happens, and nothing else
    touch,   // errors have a slope by it, and leap where it decides what is touched
  };
  Kind kind = Kind::smooth;
};

constexpr bool hasSlope(Parameter::Kind kind) {
  return kind == Parameter::Kind::smooth || kind == Parameter::Kind::touch;
}

// All that can be fitted, with bounds around `now` within the schema's ranges.
std::vector<Parameter> parametersAround(schema::PhysicsParams::Reader now);

// In their order, each once. The error names those there are.
Result<std::vector<Parameter>> parametersNamed(const std::vector<std::string>& names,
                                               schema::PhysicsParams::Reader now);

double valueOf(schema::PhysicsParams::Reader params, std::string_view name);
void setValue(schema::PhysicsParams::Builder params, std::string_view name, double value);

// The same of a name and a value that somebody typed. Errors: no such parameter, out of range.
Status setNamed(schema::PhysicsParams::Builder params, const std::string& name, double value);

// A parameter's share is what the optimiser sees: its bounds are 0 and 1, and what is between them
// goes by logarithms, which 0 has none of. What is beyond a bound has the share of the bound.
double shareOf(const Parameter& parameter, double value);
double valueAt(const Parameter& parameter, double share);

}  // namespace obby::calibrate
