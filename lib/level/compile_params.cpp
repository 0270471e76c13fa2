// Physics parameters are copied from the record by name, and checked against the schema's ranges by
// reflection.
#include "level/compile_params.h"

#include <capnp/dynamic.h>
#include <capnp/schema.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace obby::level {
namespace {

// Id of the `range` annotation in schema/obby.capnp.
constexpr uint64_t kRangeAnnotation = 0xd2a9f8e3b7c61a55;

std::optional<schema::Interval::Reader> rangeOf(capnp::StructSchema::Field field) {
  for (auto annotation : field.getProto().getAnnotations()) {
    if (annotation.getId() == kRangeAnnotation) {
      return annotation.getValue().getStruct().getAs<schema::Interval>();
    }
  }
  return std::nullopt;
}

Status checkRanges(schema::PhysicsParams::Reader record) {
  const capnp::DynamicStruct::Reader dynamic(record);
  for (auto field : dynamic.getSchema().getFields()) {
    const auto range = rangeOf(field);
    if (!range) continue;
    const double value = dynamic.get(field).as<double>();
    // The bounds are rounded as the field is: the float nearest to 0.2 is a little larger.
    if (value >= double(float(range->getMin())) && value <= double(float(range->getMax())))
      continue;
    return Error{{},
                 {},
                 fmt::format("physics.{}", field.getProto().getName().cStr()),
                 fmt::format("expected a number from {} to {}, found {}", range->getMin(),
                             range->getMax(), value),
                 {}};
  }
  return {};
}

void derive(Params& p) {
  p.tickSeconds = 1.0f / float(p.controlRate);
  p.substepSeconds = p.tickSeconds / float(p.substeps);
  // This runs once on the host. Rounding hides any difference in the last bits of libm's cosine.
  p.slopeNormalY = float(std::round(std::cos(double(p.maxSlope)) * 1e6) / 1e6);
  p.plainGrip = pairFriction(p, 0.3f, 1);
  const auto steps = [&p](float seconds) {
    return uint32_t(std::min(seconds / p.substepSeconds + 0.5f, 65535.0f));
  };
  p.landedSteps = uint16_t(std::min(steps(p.landedTime), 255u));
  // Counters for these limits start at 0, and a limit of 0 would be reached at once.
  const auto positiveTicks = [&p](float seconds) {
    return uint16_t(std::max(1u, ticksFromSeconds(p, seconds)));
  };
  p.coyoteSteps = uint16_t(std::max(1u, steps(p.coyoteTime)));
  p.graceSteps = uint16_t(std::max(1u, steps(p.offFloorGrace)));
  p.squeezeTicks = positiveTicks(p.squeezeTime);
  p.sleepTicks = positiveTicks(p.sleepTime);
}

}  // namespace

schema::Interval::Reader paramRange(const std::string& name) {
  const auto field = capnp::Schema::from<schema::PhysicsParams>().getFieldByName(name.c_str());
  return rangeOf(field).value();  // tests/level/params_test.cpp checks that every field has a range
}

Result<Params> compileParams(schema::PhysicsParams::Reader record) {
  OBBY_RETURN_IF_ERROR(checkRanges(record));
  const capnp::DynamicStruct::Reader dynamic(record);
  Params p{};
#define OBBY_PARAM_COPY(type, name) p.name = dynamic.get(#name).as<type>();
  OBBY_PHYSICS_PARAMS(OBBY_PARAM_COPY)
#undef OBBY_PARAM_COPY
  if (p.bodyTop <= p.headBottom || p.headBottom <= p.hipHeight) {
    return Error{{},
                 {},
                 "physics.bodyTop",
                 fmt::format("expected hipHeight < headBottom < bodyTop, found {}, {} and {}",
                             p.hipHeight, p.headBottom, p.bodyTop),
                 {}};
  }
  derive(p);
  // The legs are a damped spring. Steps that are too long make it unstable.
  if (!(p.hoverDamping * p.substepSeconds < 2)) {
    return Error{{},
                 {},
                 "physics.substeps",
                 fmt::format("the simulated legs are unstable with physics steps of {:.4f} s",
                             p.substepSeconds),
                 fmt::format("raise controlRate or substeps until their product is above {:.0f}",
                             p.hoverDamping / 2)};
  }
  return p;
}

}  // namespace obby::level
