// Recordings that include moving parts, dynamic parts and the player's facing.
#include "calibrate/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "calibrate/course.h"

namespace obby::calibrate {
namespace {

struct Course {
  io::RecordBuilder record;
  level::Level level = [this] {
    writeCourse(record.root().initLevel());
    return *level::Level::compile(record.reader().getLevel());
  }();

  Track rehearsed(const std::string& name) const {
    for (const Manoeuvre& m : manoeuvres()) {
      if (m.name == name) return rehearse(level, m, 0, 1);
    }
    ADD_FAILURE() << "no manoeuvre " << name;
    return {};
  }
  // Returns a ride on the ferry whose recorder started 50 ticks late.
  Track lateRide() const {
    Track track = rehearsed("ride the ferry");
    for (int i = 0; i < 50; ++i) track.drop(0);
    const double begin = track.frames.front().time;
    for (Frame& f : track.frames) f.time -= begin;
    return track;
  }
  schema::Level::Reader reader() const { return record.reader().getLevel(); }
};

// Returns the largest position error, in studs.
float maxOff(const Track& track, const std::vector<Window>& windows,
             const level::LevelView& level) {
  float max = 0;
  playBack(level, track, windows, 0, [&](uint32_t, uint32_t frame, const Moment& m) {
    max = std::max(max, length(m.position - track.frames[frame].position));
  });
  return max;
}

size_t shown(const Track& track, uint32_t part) {
  return size_t(std::find(track.parts.begin(), track.parts.end(), part) - track.parts.begin());
}

uint32_t partNamed(const Course& course, const std::string& name) {
  const auto parts = course.reader().getParts();
  for (uint32_t i = 0; i < parts.size(); ++i) {
    if (parts[i].getName() == name.c_str()) return i;
  }
  return 0;
}

TEST(Surroundings, TheClockOfARecordingIsFoundFromItsMovingParts) {
  const Course course;
  Track track = course.lateRide();
  ASSERT_TRUE(place(track, course.reader(), course.level));
  EXPECT_EQ(track.tickAt(0, course.level.view().params), 50u);
  EXPECT_TRUE(straysOf(track, course.level.view()).empty());
}

// The clock is found in frames. If the rules run in each step, it is the same time in seconds.
TEST(Surroundings, TheClockIsATimeAtAnyRate) {
  const Course course;
  Track track = course.lateRide();
  ASSERT_TRUE(place(track, course.reader(), course.level));
  io::RecordBuilder plain(course.record.reader()), params;
  params.root().initParams().setControlRate(240);
  params.root().getParams().setSubsteps(1);
  const Take take{track, io::Record(std::move(plain))};
  const auto quick = levelWith(take, params.reader().getParams());
  ASSERT_TRUE(quick) << quick.error().text();
  EXPECT_EQ(worldAt(take.track, 0, quick->view()).tick, 200u);
  EXPECT_TRUE(straysOf(take.track, quick->view()).empty());
}

// The recorder dropped frames at the start of the window. The ferry's position must still be right.
TEST(Surroundings, TheClockContinuesOverMissingFrames) {
  const Course course;
  Track track = course.rehearsed("ride the ferry");
  ASSERT_TRUE(place(track, course.reader(), course.level));
  const uint32_t first = 30;
  const size_t begin = 6;  // 0.4 s earlier
  for (int i = 0; i < 5; ++i) track.drop(begin - 2);
  EXPECT_LT(maxOff(track, {{first - 5, first + 20}}, course.level.view()), 0.02f);
}

TEST(Surroundings, APartWithAnotherMotionIsNamed) {
  const Course course;
  Track track = course.rehearsed("ride the ferry");
  const size_t ferry = shown(track, partNamed(course, "Ferry"));
  for (size_t f = 0; f < track.frames.size(); ++f)
    track.poses[f * track.shown.size() + ferry].position.y += float(f) * 0.02f;
  ASSERT_TRUE(place(track, course.reader(), course.level));
  const auto strays = straysOf(track, course.level.view());
  ASSERT_EQ(strays.size(), 1u);
  EXPECT_EQ(strays[0].part, track.shown[ferry]);
  EXPECT_GT(strays[0].studs, 2);
}

TEST(Surroundings, AnUnknownPartIsAnError) {
  const Course course;
  Track track = course.rehearsed("push the box");
  track.shown[0] = "Bxo";
  const Status wrong = place(track, course.reader(), course.level);
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().text().find("parts[0]"), std::string::npos) << wrong.error().text();
}

// Windows that begin during the push start with the box's recorded position and velocity.
TEST(Surroundings, WindowsMayBeginDuringAPush) {
  const Course course;
  const Track track = course.rehearsed("push the box");
  ASSERT_TRUE(showsBodies(track, course.level.view()));
  const auto windows = windowsOf(track, 0.5, course.level.view());
  ASSERT_GT(windows.size(), 4u);
  EXPECT_LT(maxOff(track, windows, course.level.view()), 0.05f);
}

TEST(Surroundings, ATrackAlongAnUnrecordedBoxIsOneWindow) {
  const Course course;
  Track pushed = course.rehearsed("push the box"), other = course.rehearsed("jump over gaps");
  for (Track* t : {&pushed, &other}) {
    t->shown.clear(), t->parts.clear(), t->poses.clear();
  }
  EXPECT_EQ(windowsOf(pushed, 0.5, course.level.view()).size(), 1u);
  EXPECT_GT(windowsOf(other, 0.5, course.level.view()).size(), 4u);
}

// The recorded player looks away from the truss. The facing must not be guessed from the direction
// of the walk.
TEST(Surroundings, FacingIsTakenFromTheRecording) {
  const Course course;
  const Track track = course.rehearsed("turn a little and about");
  const uint32_t middle = uint32_t(track.frames.size()) / 2;
  EXPECT_EQ(worldAt(track, middle, course.level.view()).yaw,
            headingOf(track.frames[middle].facing.x, track.frames[middle].facing.z));
  float max = 0;
  playBack(course.level.view(), track, windowsOf(track, 0.5, course.level.view()), 0,
           [&](uint32_t, uint32_t frame, const Moment& m) {
             max = std::max(max, length(m.facing - track.frames[frame].facing));
           });
  EXPECT_LT(max, 0.02f);
}

}  // namespace
}  // namespace obby::calibrate
