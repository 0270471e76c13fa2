// What a playback tells of parts that clocks take away, bring, and move.
#include "view/replay.h"

#include <gtest/gtest.h>

#include <capnp/message.h>

#include "support/level_builder.h"

namespace obby::view {
namespace {

using schema::Part;

// On a button: a door opens for a second, a bridge is there only then, a lift rises.
level::Level buttonLevel() {
  const auto respond = [](Part::Builder p, bool inverted) {
    p.initVanish().setTrigger(schema::VanishTrigger::SIGNAL);
    p.getVanish().setSignal("door");
    p.getVanish().setInverted(inverted);
  };
  support::LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}, [](Part::Builder p) {
    p.initButton().setSignal("door");
    p.getButton().setSeconds(1);
  });
  b.block({20, 0, 0}, {1, 1, 1}, [=](Part::Builder p) { respond(p, false); });
  b.block({30, 0, 0}, {1, 1, 1}, [=](Part::Builder p) { respond(p, true); });
  b.block({40, 0, 0}, {1, 1, 1}, [](Part::Builder p) {
    auto motion = p.initMotion();
    motion.setTrigger(schema::MotionTrigger::SIGNAL);
    motion.setSignal("door");
    auto keys = motion.initKeys(2);
    support::set(keys[1].initPosition(), {40, 9, 0});
    keys[1].setTime(2);
  });
  return b.compile();
}

Playback standing(const level::Level& level, uint32_t ticks) {
  capnp::MallocMessageBuilder message;
  auto path = message.initRoot<schema::Trajectory>();
  path.initActions(1)[0].setTicks(ticks);
  auto playback = playBack(level, nullptr, path.asReader());
  EXPECT_TRUE(playback) << playback.error().text();
  return *std::move(playback);
}

TEST(Replay, TellsWhenSignalsOpenCloseAndMoveParts) {
  const level::Level level = buttonLevel();
  const Playback p = standing(level, 100);
  ASSERT_EQ(p.events.size(), 3u) << "a signal that starts anew goes on";
  EXPECT_EQ(p.events[0].part, 2u) << "the bridge is away from the start";
  EXPECT_FALSE(p.events[0].solid);
  EXPECT_EQ(p.events[0].tick, 0u);
  EXPECT_EQ(p.events[1].part, 1u);
  EXPECT_FALSE(p.events[1].solid);
  EXPECT_EQ(p.events[2].part, 2u);
  EXPECT_TRUE(p.events[2].solid);
  const uint32_t pressed = p.events[1].tick;
  ASSERT_GE(p.motions.size(), 2u);
  EXPECT_EQ(p.motions[0].part, 3u);
  EXPECT_EQ(p.motions[0].tick, pressed);
  EXPECT_EQ(p.motions[0].start, int64_t(pressed));
  EXPECT_EQ(p.motions[1].tick, pressed + 60) << "starts anew: the player still stands there";
  EXPECT_EQ(p.motions[1].start, int64_t(pressed) + 60);
}

}  // namespace
}  // namespace obby::view
