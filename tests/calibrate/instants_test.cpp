// The age of recorded velocities is found and corrected. Recordings without this error stay
// unchanged.
#include "calibrate/instants.h"

#include <gtest/gtest.h>

#include "calibrate/course.h"
#include "support/recording_faults.h"

namespace obby::calibrate {
namespace {

std::vector<Take> late(std::vector<Take> takes, float share) {
  for (Take& take : takes) take.track = test::withLateVelocities(take.track, share);
  return takes;
}

TEST(Instants, OurOwnVelocitiesHaveAgeZero) {
  for (const float noise : {0.0f, 0.01f, 0.05f})
    EXPECT_EQ(velocityAgeOf(takesUnder(defaults(), noise), defaults()), 0) << noise;
}

TEST(Instants, AgeIsFound) {
  for (const float noise : {0.0f, 0.01f}) {
    const std::vector<Take> takes = takesUnder(defaults(), noise);
    for (const float share : {0.125f, 0.5f, 1.0f}) {
      const double age = double(share) / 60;
      EXPECT_NEAR(velocityAgeOf(late(takes, share), defaults()), age, 0.05 * age + 1e-4)
          << noise << " " << share;
    }
  }
}

TEST(Instants, AgeIsFoundForABadRecorder) {
  std::vector<Take> takes = late(takesUnder(defaults()), 0.5f);
  for (Take& take : takes)
    take.track = test::spoiled(take.track, {.noise = 0.01f, .dropped = 0.1f, .jitter = 0.004},
                               take.track.frames.size());
  EXPECT_NEAR(velocityAgeOf(takes, defaults()), 0.5 / 60, 0.1 * 0.5 / 60);
}

TEST(Instants, AStandingPlayerDeterminesNoAge) {
  std::vector<Take> takes = takesUnder(defaults(), 0.01f, firstManoeuvres(1));
  takes[0].track.frames.resize(20);
  EXPECT_EQ(velocityAgeOf(takes, defaults()), 0);
}

// Falls show the largest differences. At take-offs and landings the velocity jumps for other
// reasons.
TEST(Instants, OldVelocitiesAreCorrected) {
  const std::vector<Take> takes = takesUnder(defaults(), 0, firstManoeuvres(2));
  const std::vector<Take> mended = withVelocitiesOfNow(late(takes, 0.25f), defaults());
  ASSERT_EQ(mended.size(), takes.size());
  const auto &now = mended[1].track.frames, &then = takes[1].track.frames;
  size_t falling = 0;
  for (size_t i = 3; i + 3 < now.size(); ++i) {
    // Skips frames whose interpolation includes a take-off or a landing.
    const auto falls = [&](size_t k) { return then[k].state == sim::State::freefall; };
    if (!falls(i - 1) || !falls(i) || !falls(i + 1)) continue;
    ++falling;
    EXPECT_NEAR(now[i].velocity.y, then[i].velocity.y, 0.05f) << i;
  }
  EXPECT_GT(falling, 20u);
}

TEST(Instants, RecordingsWithoutTheFaultStay) {
  const std::vector<Take> takes = takesUnder(defaults(), 0.01f, firstManoeuvres(4));
  const std::vector<Take> same = withVelocitiesOfNow(takes, defaults());
  for (size_t i = 0; i < takes.size(); ++i) {
    for (size_t k = 0; k < takes[i].track.frames.size(); ++k)
      EXPECT_EQ(same[i].track.frames[k].velocity, takes[i].track.frames[k].velocity);
  }
}

}  // namespace
}  // namespace obby::calibrate
