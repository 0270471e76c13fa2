// Players' bodies and frame rates: their tables, and their effect on a level and a query.
#include "level/player.h"

#include <capnp/dynamic.h>
#include <capnp/message.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "level/bodies.h"
#include "level/level.h"

namespace obby::level {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct AnyLevel {
  capnp::MallocMessageBuilder message;
  schema::Level::Builder root = message.initRoot<schema::Level>();
};

struct AnyQuery {
  capnp::MallocMessageBuilder message;
  schema::Query::Builder root = message.initRoot<schema::Query>();

  void bodies(std::vector<std::string> names) {
    auto list = root.initBodies(uint32_t(names.size()));
    for (uint32_t i = 0; i < list.size(); ++i) list.set(i, names[i]);
  }
  void rates(std::vector<uint16_t> rates) {
    auto list = root.initFrameRates(uint32_t(rates.size()));
    for (uint32_t i = 0; i < list.size(); ++i) list.set(i, rates[i]);
  }
};

TEST(Bodies, EveryRowMakesAValidLevel) {
  for (const Body& body : bodies()) {
    AnyLevel level;
    setBody(body, level.root.getPhysics());
    EXPECT_TRUE(compileParams(level.root.getPhysics())) << body.name;
  }
}

TEST(Bodies, DifferFromThePhysicsDefaultsInTheirTractionOnly) {
  AnyLevel usual, r6, r15;
  setBody(*findBody("r6"), r6.root.getPhysics());
  setBody(*findBody("r15"), r15.root.getPhysics());
  EXPECT_EQ(r6.root.getPhysics().getTraction(), 2060);
  EXPECT_EQ(r15.root.getPhysics().getTraction(), 2777);
  const capnp::DynamicStruct::Reader a(usual.root.getPhysics().asReader());
  const capnp::DynamicStruct::Reader b(r15.root.getPhysics().asReader());
  for (const auto field : a.getSchema().getFields()) {
    const std::string name = field.getProto().getName();
    if (name == "traction") continue;
    EXPECT_EQ(a.get(field).as<double>(), b.get(field).as<double>()) << name;
  }
}

TEST(Bodies, ChangeOnlyParametersOfTheBody) {
  AnyLevel level;
  auto physics = level.root.getPhysics();
  physics.setHipHeight(1.2f);
  physics.setBodyWidth(1.5f);
  physics.setWalkSpeed(20);
  ASSERT_TRUE(setPlayer({"r6", 0}, level.root));
  EXPECT_EQ(physics.getHipHeight(), 2);
  EXPECT_EQ(physics.getBodyWidth(), 2);
  EXPECT_EQ(physics.getWalkSpeed(), 20);
}

TEST(FrameRates, AreWholeNumbersOfPhysicsSteps) {
  for (const FrameRate& rate : frameRates()) {
    AnyLevel level;
    ASSERT_TRUE(setPlayer({"", rate.framesPerSecond}, level.root));
    const auto params = compileParams(level.root.getPhysics());
    ASSERT_TRUE(params) << rate.framesPerSecond;
    const int steps = params->controlRate * params->substeps;
    EXPECT_EQ(steps, rate.framesPerSecond == 144 ? 288 : 240);
  }
}

TEST(Players, DefaultToTheLevelsOwn) {
  AnyQuery query;
  EXPECT_FALSE(namesPlayers(query.root));
  EXPECT_THAT(*playersOf(query.root), ElementsAre(Player{}));
}

TEST(Players, AreEveryCombinationWithoutRepeats) {
  AnyQuery query;
  query.bodies({"r6", "place", "r6"});
  query.rates({30, 60});
  EXPECT_THAT(*playersOf(query.root),
              ElementsAre(Player{"r6", 30}, Player{"r6", 60}, Player{"", 30}, Player{"", 60}));
}

TEST(Players, UnknownPlayersAreErrorsThatNameTheField) {
  AnyQuery query;
  query.bodies({"r6", "r7"});
  const auto body = playersOf(query.root);
  ASSERT_FALSE(body);
  EXPECT_THAT(body.error().text(), HasSubstr("bodies[1]: unknown body 'r7' (give r6 or r15"));
  query.bodies({});
  query.rates({61});
  const auto rate = playersOf(query.root);
  ASSERT_FALSE(rate);
  EXPECT_THAT(rate.error().text(),
              HasSubstr("frameRates[0]: expected 30, 60, 120, 144 or 240, found 61"));
}

TEST(Players, AQueryKeepsItsTimesAtAnotherFrameRate) {
  AnyQuery query;
  query.rates({240});
  query.root.initStart().setTick(77);
  setRate(60, 240, query.root);
  EXPECT_EQ(query.root.getStart().getTick(), 308u);
  EXPECT_FALSE(namesPlayers(query.root));
}

TEST(Ticks, RoundToTheNearestOrNextTick) {
  EXPECT_EQ(tickAtRate(77, 60, 30), 39u);
  EXPECT_EQ(tickAtRate(76, 60, 144), 182u);
  EXPECT_EQ(nextTickAtRate(5, 30, 144), 24u);
  EXPECT_EQ(nextTickAtRate(6, 30, 144), 29u);
  EXPECT_EQ(nextTickAtRate(4294967295u, 60, 60), 4294967295u);
}

}  // namespace
}  // namespace obby::level
