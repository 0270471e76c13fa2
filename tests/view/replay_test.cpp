// A playback reports the parts that clocks remove, bring back and move.
#include "view/replay.h"

#include <gtest/gtest.h>

#include <capnp/message.h>

#include <array>
#include <tuple>
#include <vector>

#include "sim/rigid_body.h"
#include "support/level_builder.h"

namespace obby::view {
namespace {

using schema::Part;

// Returns a level whose player stands on a button. While its signal lasts, for a second, a door is
// open and a bridge exists, and a lift rises.
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

TEST(Replay, ReportsWhenSignalsOpenCloseAndMoveParts) {
  const level::Level level = buttonLevel();
  const Playback p = standing(level, 100);
  ASSERT_EQ(p.events.size(), 3u) << "a signal that starts again continues";
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
  EXPECT_EQ(p.motions[1].tick, pressed + 60) << "starts again: the player still stands there";
  EXPECT_EQ(p.motions[1].start, int64_t(pressed) + 60);
}

PartEvents eventsOf(const std::vector<sim::World>& worlds, const level::LevelView& view,
                    size_t max = kMaxPartEvents) {
  PartWatch watch(view, max);
  for (uint32_t tick = 0; tick < worlds.size(); ++tick) {
    watch.see({tick, worlds[tick == 0 ? 0 : tick - 1], worlds[tick], {}});
  }
  return watch.take();
}

// One button removes and restores thousands of parts for hours.
TEST(Replay, VisitsOnlyPartsWhoseClockRuns) {
  constexpr uint32_t kOfEach = 1000, kTicks = 200'000;
  support::LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}, [](Part::Builder p) {
    p.initButton().setSignal("door");
    p.getButton().setSeconds(1);
  });
  for (uint32_t i = 0; i < 2 * kOfEach; ++i) {
    b.block({40 + 2 * float(i), 0, 0}, {1, 1, 1}, [=](Part::Builder p) {
      if (i % 2 == 0) {
        p.initVanish().setTrigger(schema::VanishTrigger::SIGNAL);
        p.getVanish().setSignal("door");
      } else {
        p.initFall();  // has its own clock, which never starts
      }
    });
  }
  const level::Level level = b.compile();
  const level::LevelView& view = level.view();
  std::vector<sim::World> worlds(kTicks, sim::makeWorld(view, {}));
  uint32_t door = 0;
  while (door < view.clockCount && view.clocks[door].length != 60) ++door;
  ASSERT_LT(door, view.clockCount);
  for (const uint32_t pressed : {500u, 100'000u, 180'000u}) {
    for (uint32_t t = 0; t < 60; ++t) {
      worlds[pressed + t].clocks[0] = {door, t};
      worlds[pressed + t].clockCount = 1;
    }
  }
  const PartEvents all = eventsOf(worlds, view);
  EXPECT_FALSE(all.cut);
  EXPECT_TRUE(all.motions.empty());
  ASSERT_EQ(all.events.size(), 6 * kOfEach);
  for (uint32_t i = 0; i < all.events.size(); ++i) {
    const uint32_t round = i / kOfEach;
    const uint32_t pressed = std::array{500u, 100'000u, 180'000u}[round / 2];
    ASSERT_EQ(all.events[i].tick, pressed + round % 2 * 60) << i;
    ASSERT_EQ(all.events[i].part, 1 + 2 * (i % kOfEach)) << i;
    ASSERT_EQ(all.events[i].solid, round % 2 == 1) << i;
  }
  const PartEvents some = eventsOf(worlds, view, 3 * kOfEach + 1);
  EXPECT_TRUE(some.cut);
  EXPECT_EQ(some.events.size(), 3 * kOfEach) << "whole ticks";
}

// Returns a level with three crates: one ahead of the spawn, one that nothing touches, and one in
// the air.
level::Level crateLevel() {
  const auto bodies = [](Part::Builder p) { p.setAnchored(false); };
  support::LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 60});
  b.block({0, 2, -6}, {4, 4, 4}, bodies);
  b.block({20, 1, 0}, {2, 2, 2}, bodies);
  b.block({-20, 9, 0}, {2, 2, 2}, bodies);
  return b.compile();
}

struct Pushed {
  level::Level level = crateLevel();
  Playback playback;
  sim::Replay replay;

  Pushed() {
    capnp::MallocMessageBuilder message;
    auto path = message.initRoot<schema::Trajectory>();
    auto run = path.initActions(1)[0];
    run.setTicks(150);
    run.setWalk(true);
    playback = *playBack(level, nullptr, path.asReader());
    replay = sim::replay(level.view(), nullptr, *sim::planFromRecord(path.asReader()));
  }

  const BodyTrack* trackOf(uint32_t part) const {
    for (const BodyTrack& track : playback.bodies) {
      if (track.part == part) return &track;
    }
    return nullptr;
  }
};

// Returns the position of a corner of the body, interpolated from its track in the same way as the
// page does.
Vec3 cornerAt(const BodyTrack& track, uint32_t tick, Vec3 corner) {
  size_t i = 0;
  while (i + 2 < track.ticks.size() && track.ticks[i + 1] <= tick) ++i;
  const float share = float(tick - track.ticks[i]) / float(track.ticks[i + 1] - track.ticks[i]);
  const auto mixed = [&](const auto& values, size_t width, size_t k) {
    return float(values[width * i + k]) * (1 - share) + float(values[width * (i + 1) + k]) * share;
  };
  const auto& [p, q] = std::tie(track.positions, track.rotations);
  const Quat turn = normalize(Quat{mixed(q, 4, 0), mixed(q, 4, 1), mixed(q, 4, 2), mixed(q, 4, 3)});
  return Vec3{mixed(p, 3, 0), mixed(p, 3, 1), mixed(p, 3, 2)} + toMat3(turn) * corner;
}

TEST(Replay, DynamicPartsFollowTheSimulator) {
  const Pushed pushed;
  const level::LevelView& view = pushed.level.view();
  ASSERT_EQ(view.bodyCount, 3u);
  const BodyTrack* track = pushed.trackOf(1);
  ASSERT_NE(track, nullptr);
  const uint32_t ticks = pushed.playback.ticks();
  ASSERT_EQ(track->ticks.back(), ticks);
  EXPECT_LT(track->positions.end()[-1], -10) << "pushed some studs ahead";
  for (uint32_t tick = 0; tick <= ticks; ++tick) {
    const Pose pose = sim::poseOf(pushed.replay.bodiesAtTick(tick)[0], view.bodies[0]);
    for (const Vec3 corner : {Vec3{2, 2, 2}, Vec3{-2, 2, -2}, Vec3{2, -2, -2}}) {
      const Vec3 truth = pose.position + pose.rotation * corner;
      ASSERT_LT(length(cornerAt(*track, tick, corner) - truth), 2 * kBodyMiss) << tick;
    }
  }
}

// Only changes are sampled. A rest needs no memory, and its duration is kept.
TEST(Replay, APartThatRestsMovesAndRestsHasFourSamples) {
  const level::Level level = crateLevel();
  const level::LevelView& view = level.view();
  const sim::World world = sim::makeWorld(view, {});
  std::vector<sim::RigidBody> bodies = sim::startBodies(view);
  BodyWatch watch(view);
  for (uint32_t tick = 0; tick <= 2000; ++tick) {
    if (tick > 1000 && tick <= 1010) bodies[1].position.x += 0.25f;
    watch.see({tick, world, world, bodies});
  }
  const std::vector<BodyTrack> tracks = watch.tracks();
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].part, 2u);
  EXPECT_EQ(tracks[0].ticks, (std::vector<uint32_t>{0, 1000, 1010, 2000}));
  ASSERT_EQ(tracks[0].positions.size(), 12u);
  EXPECT_NEAR(tracks[0].positions[0], 20, 1e-4);
  EXPECT_NEAR(tracks[0].positions[3], 20, 1e-4);
  EXPECT_NEAR(tracks[0].positions[6], 22.5, 1e-4);
  EXPECT_NEAR(tracks[0].positions[9], 22.5, 1e-4);
}

TEST(Replay, OnlyDynamicPartsThatMoveHaveTracks) {
  const Pushed pushed;
  EXPECT_EQ(pushed.trackOf(3), nullptr) << "it has fallen before play begins";
  const BodyTrack* rests = pushed.trackOf(2);
  if (rests != nullptr) {  // the crate settles by an invisible amount
    EXPECT_NEAR(rests->positions.end()[-2], rests->positions[1], 0.02);
    EXPECT_LT(rests->ticks.size(), 60u);
  }
  EXPECT_TRUE(standing(buttonLevel(), 100).bodies.empty());
}

}  // namespace
}  // namespace obby::view
