// The schema's physics parameters match the simulator's struct and its defaults. Every field states
// its unit, range and source, and ranges are enforced.
#include "level/params.h"

#include <capnp/dynamic.h>
#include <capnp/message.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "level/level.h"
#include "schema/obby.capnp.h"

namespace obby::level {
namespace {

constexpr uint64_t kUnit = 0xb0f5e1a7d9c3a2e4, kRange = 0xd2a9f8e3b7c61a55,
                   kSource = 0xa6e4d3c2b1f09876;

capnp::StructSchema schemaOf() { return capnp::Schema::from<schema::PhysicsParams>(); }

// Returns the struct's fields by name, as numbers.
std::map<std::string, double> fieldsOf(const Params& p) {
  std::map<std::string, double> out;
#define OBBY_PARAM_ENTRY(type, name) out[#name] = double(p.name);
  OBBY_PHYSICS_PARAMS(OBBY_PARAM_ENTRY)
#undef OBBY_PARAM_ENTRY
  return out;
}

Result<Params> compileWith(const std::string& field, double value) {
  capnp::MallocMessageBuilder message;
  auto record = message.initRoot<schema::PhysicsParams>();
  capnp::DynamicStruct::Builder(record).set(field, value);
  return compileParams(record.asReader());
}

schema::Interval::Reader rangeOf(capnp::StructSchema::Field field) {
  for (auto a : field.getProto().getAnnotations()) {
    if (a.getId() == kRange) return a.getValue().getStruct().getAs<schema::Interval>();
  }
  return {};
}

TEST(Params, HaveTheFieldsAndDefaultsOfTheSchema) {
  capnp::MallocMessageBuilder message;
  const auto record = message.initRoot<schema::PhysicsParams>().asReader();
  const auto params = compileParams(record);
  ASSERT_TRUE(bool(params)) << params.error().text();
  std::map<std::string, double> fromSchema;
  const capnp::DynamicStruct::Reader dynamic(record);
  for (auto field : schemaOf().getFields()) {
    fromSchema[field.getProto().getName().cStr()] = dynamic.get(field).as<double>();
  }
  EXPECT_EQ(fieldsOf(*params), fromSchema);
}

TEST(Params, AreCopiedFieldByField) {
  for (auto field : schemaOf().getFields()) {
    const std::string name = field.getProto().getName().cStr();
    const auto range = rangeOf(field);
    for (const double share : {0.25, 0.5, 0.75}) {
      const double value = std::floor(range.getMin() + share * (range.getMax() - range.getMin()));
      if (value < range.getMin()) continue;
      const auto params = compileWith(name, value);
      if (!params) continue;  // contradictory heights
      auto expected = fieldsOf(*compileWith("gravity", 196.2f));
      expected[name] = value;
      EXPECT_EQ(fieldsOf(*params), expected) << name;
    }
  }
}

TEST(Params, EveryFieldStatesItsUnitRangeAndSource) {
  for (auto field : schemaOf().getFields()) {
    std::map<uint64_t, std::string> texts;
    std::set<uint64_t> ids;
    for (auto a : field.getProto().getAnnotations()) {
      ids.insert(a.getId());
      if (a.getValue().isText()) texts[a.getId()] = a.getValue().getText().cStr();
    }
    const std::string name = field.getProto().getName().cStr();
    EXPECT_FALSE(texts[kUnit].empty()) << name;
    ASSERT_FALSE(texts[kSource].empty()) << name;
    const std::string& source = texts[kSource];
    EXPECT_TRUE(source.starts_with("measured") ||
                std::string("HML").find(source[0]) != std::string::npos)
        << name << ": a source starts with its confidence";
    ASSERT_TRUE(ids.count(kRange)) << name;
    EXPECT_LT(rangeOf(field).getMin(), rangeOf(field).getMax()) << name;
  }
}

TEST(Params, AreValidAtTheEndsOfTheirRange) {
  for (auto field : schemaOf().getFields()) {
    const std::string name = field.getProto().getName().cStr();
    for (const double value : {rangeOf(field).getMin(), rangeOf(field).getMax()}) {
      const auto params = compileWith(name, value);
      if (params) continue;
      EXPECT_EQ(params.error().message.find("expected a number from"), std::string::npos)
          << name << " " << value << ": " << params.error().text();
    }
  }
}

TEST(Params, OutsideTheirRangeAreRefusedByName) {
  for (auto field : schemaOf().getFields()) {
    const std::string name = field.getProto().getName().cStr();
    const auto range = rangeOf(field);
    const bool whole = field.getType().isUInt16();
    std::vector<double> bad{range.getMax() + (whole ? 1 : 0.001 * (1 + range.getMax()))};
    if (!whole || range.getMin() >= 1) bad.push_back(range.getMin() - (whole ? 1 : 0.01));
    if (!whole) bad.push_back(std::numeric_limits<double>::quiet_NaN());
    if (!whole) bad.push_back(std::numeric_limits<double>::infinity());
    for (const double value : bad) {
      const auto params = compileWith(name, value);
      ASSERT_FALSE(bool(params)) << name << " = " << value;
      EXPECT_EQ(params.error().path, "physics." + name);
      EXPECT_EQ(params.error().message.rfind("expected a", 0), 0u) << params.error().text();
    }
  }
}

TEST(Params, HeightsOfABodyMustBeInOrder) {
  for (const auto& [field, value] :
       {std::pair<const char*, double>{"bodyTop", 3.5}, {"headBottom", 1.5}, {"hipHeight", 4.5}}) {
    const auto params = compileWith(field, value);
    ASSERT_FALSE(bool(params)) << field;
    EXPECT_NE(params.error().message.find("expected hipHeight < headBottom < bodyTop"),
              std::string::npos);
  }
}

TEST(Params, DerivedTimesAreWholePhysicsSteps) {
  const auto p = compileWith("controlRate", 100);
  ASSERT_TRUE(bool(p));
  EXPECT_FLOAT_EQ(p->tickSeconds, 0.01f);
  EXPECT_FLOAT_EQ(p->substepSeconds, 0.0025f);
  EXPECT_EQ(p->landedSteps, 20);
  EXPECT_EQ(p->coyoteSteps, 47);
  EXPECT_EQ(p->graceSteps, 47);
  EXPECT_NEAR(p->slopeNormalY, std::cos(1.5533431), 1e-6);
}

TEST(Params, TimersTakeAtLeastOneTick) {
  EXPECT_EQ(compileWith("landedTime", 0)->landedSteps, 0);
  EXPECT_EQ(compileWith("coyoteTime", 0)->coyoteSteps, 1);
  EXPECT_EQ(compileWith("offFloorGrace", 0)->graceSteps, 1);
  EXPECT_EQ(compileWith("squeezeTime", 0)->squeezeTicks, 1);
  EXPECT_EQ(compileWith("sleepTime", 0)->sleepTicks, 1);
}

TEST(TicksFromSeconds, RoundsAndStaysInRange) {
  const Params p = *compileWith("controlRate", 60);
  EXPECT_EQ(ticksFromSeconds(p, 1), 60u);
  EXPECT_EQ(ticksFromSeconds(p, 0.0249f), 1u);
  EXPECT_EQ(ticksFromSeconds(p, 0.0083f), 0u);
  EXPECT_EQ(ticksFromSeconds(p, -5), 0u);
  EXPECT_EQ(ticksFromSeconds(p, std::nanf("")), 0u);
  EXPECT_EQ(ticksFromSeconds(p, 1e30f), 1u << 24);
  EXPECT_EQ(ticksFromSeconds(p, INFINITY), 1u << 24);
}

TEST(Params, UnstableLegsAreRefused) {
  const auto at = [](uint16_t rate, uint8_t substeps) {
    capnp::MallocMessageBuilder message;
    auto record = message.initRoot<schema::PhysicsParams>();
    record.setControlRate(rate);
    record.setSubsteps(substeps);
    return compileParams(record.asReader());
  };
  EXPECT_TRUE(bool(at(60, 1)));
  const auto coarse = at(30, 1);
  ASSERT_FALSE(bool(coarse));
  EXPECT_EQ(coarse.error().path, "physics.substeps");
  EXPECT_EQ(coarse.error().hint, "raise controlRate or substeps until their product is above 55");
}

}  // namespace
}  // namespace obby::level
