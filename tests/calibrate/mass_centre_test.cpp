// Avatars whose centre of mass is off the root, and the duration of frames.
#include "calibrate/mass_centre_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "calibrate/course.h"
#include "calibrate/frame_play.h"
#include "sim/simulator.h"

namespace obby::calibrate {
namespace {

constexpr MassCentre kCentre{0.2f, -0.15f};

struct Fall {
  Take take;
  Params params;
};

// Returns a recording of a fall by an avatar with kCentre, from the `first` tick to the `last`. It
// begins `height` above the course's start and turns twice.
Fall turningFall(float height, int first, int last) {
  io::RecordBuilder record;
  writeCourse(record.root().initLevel());
  const io::Record course(std::move(record));
  const auto level = level::Level::compile(course.reader().getLevel());
  const level::LevelView view = level->view();
  sim::World w = sim::makeWorld(view, level->spawns()[0]);
  w.position.y += height;
  auto bodies = sim::startBodies(view);
  Fall out{{{"fall", course.reader().getLevel().getName()}, course}, view.params};
  for (int tick = 0; tick <= last; ++tick) {
    const sim::Action action{Turns(tick / 20 % 2 ? 0xa000 : 0x4000), true, false};
    const Vec3 offset = kCentre.at(w.yaw);
    const Vec3 move = directionOf(sinCosOf<float>(action.heading));
    if (tick >= first) {
      out.take.track.frames.push_back({(tick - first) / 60.0, move, false,
                                       rootOf(w.position, view.params) - offset, w.velocity,
                                       w.state, directionOf(sinCosOf<float>(w.yaw))});
    }
    sim::advance(w, bodies.data(), view, nullptr, action);
  }
  return out;
}

// Returns the largest position error of the simulator's player, in studs, if the recording is
// played frame by frame.
float farthest(const Take& take, const MassCentre& centre) {
  const auto level = level::Level::compile(take.level.reader().getLevel());
  const Track& track = take.track;
  const auto played = playFrames(level->view(), track, stepsOf(track, 240), centre);
  float max = 0;
  for (size_t i = 0; i < played.size(); ++i)
    max = std::max(max, length(played[i].position - track.frames[i].position));
  return max;
}

TEST(MassCentre, IsFoundInAFallThatTurns) {
  const Fall a = turningFall(60, 1, 40), b = turningFall(30, 1, 30);
  const std::vector<const Track*> tracks{&a.take.track, &b.take.track};
  const MassCentre found = massCentreOf(tracks, Track{}, a.params);
  EXPECT_NEAR(found.ahead, kCentre.ahead, 0.003);
  EXPECT_NEAR(found.right, kCentre.right, 0.003);
}

TEST(MassCentre, IgnoresTheExcludedFrames) {
  const Fall a = turningFall(60, 1, 40), same = turningFall(60, 3, 30);
  const std::vector<const Track*> tracks{&a.take.track, &same.take.track};
  EXPECT_TRUE(massCentreOf(tracks, a.take.track, a.params).isRoot());
}

TEST(MassCentre, IsTheRootWithoutATurn) {
  Fall a = turningFall(60, 1, 40);
  for (Frame& f : a.take.track.frames) f.facing = {0, 0, -1};
  const std::vector<const Track*> tracks{&a.take.track};
  EXPECT_TRUE(massCentreOf(tracks, Track{}, a.params).isRoot());
}

TEST(FramePlay, TurnsThePlayerAboutTheCentreOfMass) {
  const Fall a = turningFall(60, 1, 40);
  EXPECT_LT(farthest(a.take, kCentre), 2e-3f);
  EXPECT_GT(farthest(a.take, {}), 0.05f);
}

// The legs of a walking player drive the root, so only the recorded velocity shows the swing of the
// centre of mass.
TEST(FramePlay, LegsDriveTheRoot) {
  io::RecordBuilder record;
  writeCourse(record.root().initLevel());
  const io::Record course(std::move(record));
  const auto level = level::Level::compile(course.reader().getLevel());
  const level::LevelView view = level->view();
  sim::World w = sim::makeWorld(view, level->spawns()[0]);
  auto bodies = sim::startBodies(view);
  Take take{{"walk", course.reader().getLevel().getName()}, course};
  for (int tick = 0; tick < 80; ++tick) {
    const sim::Action action{Turns(tick < 64 ? 0 : 0x2000), tick >= 50, false};
    const sim::World before = w;
    sim::advance(w, bodies.data(), view, nullptr, action);
    if (tick < 65) continue;  // the turn has begun by then
    const Vec3 swing = (kCentre.at(w.yaw) - kCentre.at(before.yaw)) * 60;
    take.track.frames.push_back({(tick - 65) / 60.0, directionOf(sinCosOf<float>(action.heading)),
                                 false, rootOf(w.position, view.params), w.velocity + swing,
                                 w.state, directionOf(sinCosOf<float>(w.yaw))});
  }
  EXPECT_LT(farthest(take, kCentre), 0.5f * farthest(take, {}));
}

// The player starts from rest. The number of steps in the second frame differs from what the
// frame's time suggests.
TEST(FramePlay, DerivesAFramesStepsFromItsMotion) {
  const auto frame = [](double time, float place, float speed) {
    return Frame{time, {1, 0, 0}, false, {place, 3, 0}, {speed, 0, 0}, sim::State::running};
  };
  const float dt = 1 / 240.0f, gain = 618 * dt;  // per step
  const auto after = [&](int n) { return gain * dt * float(n * (n + 1)) * 0.5f; };
  Track track{"start", "course", {frame(0, 0, 0), frame(5 / 240.0, after(4), 4 * gain)}};
  EXPECT_EQ(stepsOf(track, 240), std::vector<uint32_t>{4});
  track.frames[1].velocity.x =
      3.5f * gain;  // no number of steps with constant acceleration gives this speed
  EXPECT_EQ(stepsOf(track, 240), std::vector<uint32_t>{5});
}

TEST(FramePlay, SteadyFramesHaveTheirMeanTime) {
  std::vector<uint32_t> steps;
  for (int i = 0; i < 60; ++i) steps.push_back(i % 3 == 0 ? 1 : 2);  // 144 frames a second
  for (const float own : ownSteps(steps)) EXPECT_NEAR(own, 5 / 3.0, 0.02);
  steps[30] = 9;  // a late frame
  EXPECT_EQ(ownSteps(steps)[30], 9);
  EXPECT_EQ(ownSteps(steps)[20], 2);
  EXPECT_NEAR(ownSteps(steps)[5], 5 / 3.0, 0.02);
}

// At 144 frames a second, seven frames last 0.0486 s but may hold twelve physics steps, 0.05 s. By
// the frames' own time, the 0.05 s of Landed have not passed.
TEST(FramePlay, LandedLastsByTheFramesOwnTime) {
  io::RecordBuilder record;
  writeCourse(record.root().initLevel());
  const io::Record course(std::move(record));
  const auto level = level::Level::compile(course.reader().getLevel());
  const Params& p = level->view().params;
  const Vec3 start = rootOf(level->spawns()[0].feet, p);
  for (uint32_t phase = 0; phase < 3; ++phase) {
    Take take{{"landing", course.reader().getLevel().getName()}, course};
    uint32_t steps = 0;
    for (uint32_t i = 0; i < 90; ++i) {
      take.track.frames.push_back(
          {steps / 240.0, {}, false, start + Vec3{0, 4, 0}, {}, sim::State::freefall, {0, 0, -1}});
      steps += (i + phase) % 3 == 0 ? 1 : 2;
    }
    auto longTicks = level->view();
    longTicks.params.substeps = 2;
    longTicks.params.controlRate = 120;
    const auto played = playFrames(longTicks, take.track, stepsOf(take.track, 240), {});
    const auto landed = std::count_if(played.begin(), played.end(), [](const Played& q) {
      return q.state == sim::State::landed;
    });
    EXPECT_EQ(landed, 7) << "phase " << phase << ": and the eighth is Running";
  }
}

}  // namespace
}  // namespace obby::calibrate
