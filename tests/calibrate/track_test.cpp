// Tests recordings as the real engine produces them, with late, duplicate and missing frames, and
// inputs at other rates. Also tests invalid recordings.
#include "calibrate/track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/random.h"
#include "calibrate/course.h"

namespace obby::calibrate {
namespace {

schema::Recording::Builder trackRecordOf(io::RecordBuilder& record, uint32_t frames) {
  auto recording = record.root().initRecording();
  auto list = recording.initFrames(frames);
  for (uint32_t i = 0; i < frames; ++i) list[i].setTime(i / 60.0);
  return recording;
}

TEST(Track, ReadsBackAWrittenRecording) {
  const std::vector<Take> takes = takesUnder(defaults());
  io::RecordBuilder record;
  writeRecording(takes[3].track, record.root().initRecording());
  const auto read = trackOf(record.reader().getRecording());
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->frames.size(), takes[3].track.frames.size());
  for (size_t i = 0; i < read->frames.size(); ++i) {
    const Frame &a = read->frames[i], &b = takes[3].track.frames[i];
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.position.y, b.position.y);
    EXPECT_EQ(a.state, b.state);
  }
}

TEST(Track, DropsDuplicateFrames) {
  io::RecordBuilder record;
  auto recording = trackRecordOf(record, 4);
  recording.getFrames()[2].setTime(1 / 60.0);
  const auto read = trackOf(recording);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frames.size(), 3u);
}

// If two frames have the same time, the first lasts zero seconds. A frame without poses repeats the
// poses of the previous frame, even if that frame is dropped.
TEST(Track, TheLaterDuplicateFrameGivesInputAndPoses) {
  io::RecordBuilder record;
  auto recording = trackRecordOf(record, 5);
  recording.initParts(1).set(0, "Box");
  auto frames = recording.getFrames();
  frames[0].initPoses(1);
  frames[2].setTime(1 / 60.0);
  frames[2].setJump(true);
  frames[2].initMove().setX(1);
  frames[2].initPoses(1)[0].initPosition().setY(3);
  const auto read = trackOf(recording);
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->frames.size(), 4u);
  EXPECT_FALSE(read->frames[0].jump);
  EXPECT_TRUE(read->frames[1].jump);
  EXPECT_EQ(read->frames[1].move.x, 1);
  EXPECT_FALSE(read->frames[2].jump);
  ASSERT_EQ(read->poses.size(), 4u);
  EXPECT_EQ(read->pose(0, 0).position.y, 0);
  for (const size_t i : {1, 2, 3}) EXPECT_EQ(read->pose(i, 0).position.y, 3) << i;
}

// If a number overflows, losses cannot be compared.
TEST(Track, ImpossibleNumbersAreAnError) {
  using Builder = schema::RecordingFrame::Builder;
  for (const auto& spoil : std::vector<std::function<void(Builder)>>{
           [](Builder f) { f.initPosition().setX(2e6f); },
           [](Builder f) { f.initVelocity().setY(-1e38f); },
           [](Builder f) { f.initVelocity().setZ(std::nanf("")); },
           [](Builder f) { f.initMove().setX(1e30f); },
           [](Builder f) { f.initFacing().setX(HUGE_VALF); }}) {
    io::RecordBuilder record;
    auto recording = trackRecordOf(record, 4);
    spoil(recording.getFrames()[2]);
    const auto read = trackOf(recording);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().text().find("frames[2]"), std::string::npos) << read.error().text();
  }
}

TEST(Track, NamesTheFrameWhoseTimeGoesBack) {
  io::RecordBuilder record;
  auto recording = trackRecordOf(record, 4);
  recording.getFrames()[3].setTime(0.01);
  const auto read = trackOf(recording);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("frames[3]"), std::string::npos) << read.error().text();
}

TEST(Track, TimesCountFromTheFirstFrameOn) {
  io::RecordBuilder record;
  auto recording = trackRecordOf(record, 4);
  for (auto frame : recording.getFrames()) frame.setTime(1.7e9 + frame.getTime());
  const auto read = trackOf(recording);
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->frames.size(), 4u);
  EXPECT_EQ(read->frames[0].time, 0);
  EXPECT_NEAR(read->frames[3].time, 0.05, 1e-6);
}

// Times in milliseconds, or a pause of minutes, would otherwise be simulated in full.
TEST(Track, NamesTheFrameWhoseTimeLeaps) {
  io::RecordBuilder record;
  auto recording = trackRecordOf(record, 4);
  recording.getFrames()[3].setTime(1e12);
  const auto read = trackOf(recording);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("frames[3]"), std::string::npos) << read.error().text();
}

TEST(Track, PosesAndFacingReadBack) {
  const std::vector<Take> takes = takesUnder(defaults());
  const Track& track = takes.back().track;  // a recording of a pushed box
  io::RecordBuilder record;
  writeRecording(track, record.root().initRecording());
  const auto read = trackOf(record.reader().getRecording());
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->shown, track.shown);
  ASSERT_EQ(read->poses.size(), track.poses.size());
  for (size_t i = 0; i < track.poses.size(); ++i) {
    EXPECT_EQ(read->poses[i].position, track.poses[i].position) << i;
    EXPECT_NEAR(read->poses[i].rotation.y, track.poses[i].rotation.y, 1e-6) << i;
  }
  EXPECT_EQ(read->frames[40].facing, track.frames[40].facing);
}

TEST(Track, AWrongNumberOfPosesIsAnError) {
  io::RecordBuilder record;
  auto recording = trackRecordOf(record, 4);
  recording.initParts(1).set(0, "Box");
  recording.getFrames()[0].initPoses(1);
  recording.getFrames()[2].initPoses(2);
  const auto read = trackOf(recording);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("frames[2]"), std::string::npos) << read.error().text();
}

TEST(Track, NeedsTwoFrames) {
  io::RecordBuilder record;
  EXPECT_FALSE(trackOf(trackRecordOf(record, 1)));
}

// Returns the worst residual under the true parameters, over windows that begin anywhere.
double worstOf(const std::vector<Take>& takes) {
  const std::vector<Parameter> none;
  const Objective objective(takes, none, defaults(), {});
  const auto r = objective.residuals(objective.start());
  double worst = 0;
  for (const float v : *r) worst = std::max(worst, std::fabs(double(v)));
  return worst;
}

// Any track must give a loss that can be compared.
TEST(Playback, ALossIsNeverNaN) {
  std::vector<Take> takes = takesUnder(defaults(), 0, firstManoeuvres(1));
  takes[0].track.frames.back().position.x = std::nanf("");
  const std::vector<Parameter> none;
  const Objective objective(takes, none, defaults(), {});
  EXPECT_EQ(objective.loss(objective.start()), std::numeric_limits<double>::max());
}

TEST(Playback, FollowsItsOwnRecordings) { EXPECT_LT(worstOf(takesUnder(defaults())), 0.03); }

// A tenth of the frames are missing.
TEST(Playback, FollowsARecordingWithFramesMissing) {
  std::vector<Take> takes = takesUnder(defaults());
  Random random(5, 0);
  for (Take& take : takes) {
    Track& track = take.track;
    for (size_t i = 1; i < track.frames.size(); ++i) {
      const Frame &f = track.frames[i], &before = track.frames[i - 1];
      if (random.unit() < 0.1f && f.move == before.move && f.jump == before.jump) track.drop(i--);
    }
  }
  EXPECT_LT(worstOf(takes), 0.03);
}

}  // namespace
}  // namespace obby::calibrate
