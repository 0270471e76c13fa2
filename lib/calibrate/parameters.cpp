#include "calibrate/parameters.h"

#include <capnp/dynamic.h>
#include <capnp/schema.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "level/level.h"
#include "level/record_values.h"

namespace obby::calibrate {

namespace {

// Id of the `unit` annotation in schema/obby.capnp.
constexpr uint64_t kUnitAnnotation = 0xb0f5e1a7d9c3a2e4;

struct Row {
  const char* name;
  double factor;  // upper bound = current value * factor
  const char* manoeuvre;
  Parameter::Kind kind = Parameter::Kind::smooth;
  double divisor = factor;  // lower bound = current value / divisor
  double max = 0;           // for a value that may be 0: the range is [0, max]
};

// Parameters of a walking, jumping body, each with the manoeuvre that shows it best.
constexpr Row kRows[] = {
    {"walkSpeed", 2, "run straight ahead for two seconds"},
    {"traction", 4, "start running, stop and turn back on flat ground"},
    {"airAccel", 4, "jump, and turn back in the air"},
    {"moveGain", 16, "start running from rest, and stop"},
    {"turnGain", 4, "turn a little, standing and running"},
    {"turnSpeed", 4, "turn around, standing and running"},
    {"gravity", 2, "jump on flat ground, and fall from a ledge"},
    {"jumpSpeed", 2, "jump on flat ground"},
    {"hipHeight", 1.5, "stand on flat ground"},
    {"hoverStiffness", 4, "land from a jump and from a ledge"},
    {"hoverDamping", 4, "land from a jump and from a ledge"},
    {"floorKeep", 1.3, "walk off a ledge", Parameter::Kind::event},
    {"floorAcquire", 1.3, "land from a jump", Parameter::Kind::event},
    {"floorRaySpread", 2, "walk off ledges, forward and sideways", Parameter::Kind::event},
    // The range reaches down to 0 ticks at 240 ticks a second.
    {"landedTime", 4, "hold jump for several jumps", Parameter::Kind::ticks, 30},
    {"coyoteTime", 3, "walk off a ledge and jump, waiting longer each time", Parameter::Kind::ticks,
     8},
    {"offFloorGrace", 3, "walk off a ledge", Parameter::Kind::ticks, 8},
    {"playerFriction", 3, "run and stop on parts with different frictions"},
    {"maxSlope", 1.5, "walk up ramps of increasing slope", Parameter::Kind::event},
    {"climbSpeed", 2, "climb a truss up and down"},
    {"bodyWidth", 2.5, "run into walls and through gaps", Parameter::Kind::touch},
    {"bodyDepth", 2.5, "run into walls and through gaps", Parameter::Kind::touch},
    {"pushForce", 10, "push a box"},
    {"jumpAccel", 0, "start running in the same tick as the jump", Parameter::Kind::smooth, 1, 500},
};

std::string unitOf(capnp::StructSchema::Field field) {
  for (auto annotation : field.getProto().getAnnotations()) {
    if (annotation.getId() == kUnitAnnotation) return annotation.getValue().getText();
  }
  return {};
}

Parameter parameterOf(const Row& row, schema::PhysicsParams::Reader now) {
  const auto field = capnp::Schema::from<schema::PhysicsParams>().getFieldByName(row.name);
  const double value = valueOf(now, row.name);
  const auto range = level::paramRange(row.name);
  const double lowest = row.max > 0 ? 0 : value / row.divisor;
  const double highest = row.max > 0 ? std::max(row.max, value) : value * row.factor;
  return {row.name,
          unitOf(field),
          std::max(lowest, double(range.getMin())),
          std::min(highest, double(range.getMax())),
          row.manoeuvre,
          row.kind};
}

}  // namespace

std::vector<Parameter> parametersAround(schema::PhysicsParams::Reader now) {
  std::vector<Parameter> out;
  for (const Row& row : kRows) {
    if (row.max > 0 || valueOf(now, row.name) > 0) out.push_back(parameterOf(row, now));
  }
  return out;
}

Result<std::vector<Parameter>> parametersNamed(const std::vector<std::string>& names,
                                               schema::PhysicsParams::Reader now) {
  std::vector<Parameter> out;
  const std::vector<Parameter> all = parametersAround(now);
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == name; });
    if (found == all.end()) {
      std::string known;
      for (const Parameter& p : all) known += (known.empty() ? "" : ", ") + p.name;
      return makeError(fmt::format("'{}' cannot be fitted", name), "expected one of " + known);
    }
    const bool again =
        std::any_of(out.begin(), out.end(), [&](const Parameter& p) { return p.name == name; });
    if (!again) out.push_back(*found);
  }
  return out;
}

double valueOf(schema::PhysicsParams::Reader params, std::string_view name) {
  return capnp::DynamicStruct::Reader(params)
      .get(kj::StringPtr(std::string(name).c_str()))
      .as<double>();
}

void setValue(schema::PhysicsParams::Builder params, std::string_view name, double value) {
  capnp::DynamicStruct::Builder(params).set(kj::StringPtr(std::string(name).c_str()), value);
}

Status setNamed(schema::PhysicsParams::Builder params, const std::string& name, double value) {
  const auto schema = capnp::Schema::from<schema::PhysicsParams>();
  if (schema.findFieldByName(name.c_str()) == nullptr)
    return makeError(fmt::format("there is no physics parameter '{}'", name),
                     "see docs/physics.md");
  const bool whole = value >= 0 && value <= 65535 && value == std::floor(value);
  if (schema.getFieldByName(name.c_str()).getType().isUInt16() && !whole)
    return level::pathError("physics." + name, "expected a whole number from 0 to 65535");
  setValue(params, name, value);
  OBBY_RETURN_IF_ERROR(level::compileParams(params.asReader()));
  return {};
}

double shareOf(const Parameter& p, double value) {
  const double within = std::clamp(value, p.lowest, p.highest);
  if (p.lowest <= 0) return within / p.highest;
  return std::log(within / p.lowest) / std::log(p.highest / p.lowest);
}

double valueAt(const Parameter& p, double share) {
  const double within = std::clamp(share, 0.0, 1.0);
  return p.lowest > 0 ? p.lowest * std::pow(p.highest / p.lowest, within) : p.highest * within;
}

}  // namespace obby::calibrate
