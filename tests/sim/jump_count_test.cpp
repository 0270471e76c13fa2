// A world counts jumps in 16 bits, and the count saturates. A count that wrapped to 0 would grant
// jumps that a limit has used up.
#include <gtest/gtest.h>

#include "sim/next_region.h"
#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::State;

constexpr uint16_t kMax = 0xffff;

// Expects another jump to give the maximum count, both from one below it and from the maximum.
void expectToStayAtMax(const Play& ready) {
  for (const uint16_t before : {uint16_t(kMax - 1), kMax}) {
    Play play = ready;
    play.world.jumps = before;
    play.run(stand(true));
    EXPECT_EQ(play.world.state, State::jumping);
    EXPECT_EQ(play.world.jumps, kMax) << before;
  }
}

TEST(JumpCount, SaturatesOnAFloor) {
  const auto level = flatLevel();
  Play play(level);
  expectToStayAtMax(play.settle());
}

TEST(JumpCount, SaturatesOnATruss) {
  const auto level =
      floorLevel()
          .block({0, 20, -5}, {2, 40, 2}, [](Part::Builder p) { p.setShape(schema::Shape::TRUSS); })
          .compile();
  Play play(level);
  play.settle();
  const auto hangs = [](const sim::World& w) {
    return w.state == State::climbing && w.position.y > 10;
  };
  ASSERT_GE(play.until(walk(kNorth), hangs), 0);
  expectToStayAtMax(play);
}

TEST(JumpCount, SaturatesOnASeat) {
  const auto level =
      floorLevel().block({0, 0.5f, -8}, {3, 1, 3}, [](Part::Builder p) { p.initSeat(); }).compile();
  Play play(level);
  play.settle();
  const auto sits = [](const sim::World& w) { return w.state == State::seated; };
  ASSERT_GE(play.until(walk(kNorth), sits), 0);
  expectToStayAtMax(play);
}

TEST(JumpCount, LeavesJumpsWhenSaturatedWithoutALimit) {
  level::QueryView query{};
  sim::World w{};
  w.jumps = kMax;
  EXPECT_GT(sim::jumpsLeft(query, w), 1000u);
  query.maxJumps = 3;
  EXPECT_EQ(sim::jumpsLeft(query, w), 0u);
  w.jumps = 1;
  EXPECT_EQ(sim::jumpsLeft(query, w), 2u);
}

}  // namespace
}  // namespace obby::test
