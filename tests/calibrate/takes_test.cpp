// A stream's recordings are paired with their levels, and each gets a unique name.
#include "calibrate/takes.h"

#include <gtest/gtest.h>

#include "calibrate/course.h"

namespace obby::calibrate {
namespace {

io::Record recordOf(const Track& track) {
  io::RecordBuilder out;
  writeRecording(track, out.root().initRecording());
  return io::Record(std::move(out));
}

// The takes and warnings from reading the course's level and some recordings.
struct Read {
  std::vector<Take> takes;
  std::vector<std::string> warnings;
};

Read read(const io::Record& level, const std::vector<Track>& tracks) {
  Read out;
  Takes source;
  EXPECT_TRUE(source.handle(level));
  for (const Track& track : tracks) {
    const auto then = source.handle(recordOf(track));
    EXPECT_TRUE(then) << then.error().text();
  }
  out.warnings = source.warnings();
  out.takes = source.take();
  return out;
}

TEST(Takes, NumbersTakesOfTheSameName) {
  const std::vector<Take> once = takesUnder(defaults(), 0, firstManoeuvres(1));
  Track track = once[0].track;
  track.name = "run";
  Track other = track;
  other.name = "run (2)";
  const Read got = read(once[0].level, {track, other, track, track});
  ASSERT_EQ(got.takes.size(), 4u);
  EXPECT_EQ(got.takes[0].track.name, "run");
  EXPECT_EQ(got.takes[1].track.name, "run (2)");
  EXPECT_EQ(got.takes[2].track.name, "run (3)");
  EXPECT_EQ(got.takes[3].track.name, "run (4)");
  EXPECT_TRUE(got.warnings.empty());
}

// No shift of the clock corrects this difference. A rider would be simulated at the wrong place.
TEST(Takes, APartWithAnotherMotionIsAWarning) {
  const std::vector<Take> all = takesUnder(defaults());
  io::RecordBuilder other(all[0].level.reader());
  for (auto part : other.root().getLevel().getParts()) {
    if (part.getName() == "Ferry") part.getMotion().getKeys()[1].setTime(5);
  }
  const Read got = read(io::Record(std::move(other)), {all[0].track, all[4].track, all[3].track});
  EXPECT_EQ(got.takes.size(), 3u);
  ASSERT_EQ(got.warnings.size(), 1u) << "one for one cause";
  EXPECT_NE(got.warnings[0].find("(Ferry)"), std::string::npos) << got.warnings[0];
  EXPECT_NE(got.warnings[0].find("and less in 2 other recordings"), std::string::npos)
      << got.warnings[0];
}

}  // namespace
}  // namespace obby::calibrate
