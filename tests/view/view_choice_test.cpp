// Tests from which side pictures show a query: it is not hidden behind a wall, and reads from left
// to right.
#include "view/picture/view_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "view/course.h"
#include "view/extent.h"

namespace obby::view {
namespace {

Solid wall(Vec3 center, Vec3 half) {
  Solid solid;
  solid.pose.position = center;
  solid.shape.half = half;
  return solid;
}

Subject walkAlongX() {
  Subject subject;
  for (float x = 0; x <= 40; x += 4) subject.seen.push_back({x, 2, 0});
  subject.frame = subject.seen;
  subject.from = subject.seen.front();
  subject.to = subject.seen.back();
  return subject;
}

TEST(ViewChoice, IsNotBehindAWall) {
  const Subject subject = walkAlongX();
  for (const float z : {-14.0f, 14.0f}) {
    const Vec3 look = bestLook(subject, {wall({20, 20, z}, {45, 20, 1})}, 640, 360);
    const Camera camera = framed(subject.frame, look, 640, 360, true);
    EXPECT_GT((z - camera.eye.z) * z, 0) << "the eye is on the route's side; z " << z;
  }
}

TEST(ViewChoice, AnOrthographicCameraIsNotBehindADistantWall) {
  for (const float z : {-300.0f, 300.0f}) {
    const Vec3 look = bestLook(walkAlongX(), {wall({20, 200, z}, {900, 400, 1})}, 640, 360, false);
    EXPECT_GT(look.z * z, 0) << "it looks towards the wall; z " << z;
  }
}

TEST(ViewChoice, FramesTheClosestAttemptAndTheMissingStep) {
  auto left = view_test::walk(view_test::kLeft, 300), near = view_test::walk(view_test::kAhead, 40);
  io::RecordBuilder progress,
      answer(view_test::recordOf(view_test::resultLine("unreachable", 0)).reader());
  progress.root().initProgress().setQuery("ahead");
  progress.root().getProgress().setBest(near.reader().getTrajectory());
  const std::vector<std::string> lines = {view_test::kLevel, view_test::kQuery,
                                          view_test::line(progress)};
  const auto running = view_test::collect(lines);
  ASSERT_TRUE(running) << running.error().text();
  const size_t framed = subjectOf(running->levels[0], &running->queries[0]).frame.size();
  answer.root().getResult().initCut().setTo(4);
  const auto failed = view_test::collect(
      {view_test::kLevel, view_test::kQuery, view_test::line(left), view_test::line(answer)});
  ASSERT_TRUE(failed) << failed.error().text();
  const Subject subject = subjectOf(failed->levels[0], &failed->queries[0]);
  EXPECT_EQ(subject.frame.back(), (Vec3{-24, 0, -20})) << "the rock";
  EXPECT_GT(framed, subject.frame.size()) << "failed attempts are not framed";
}

TEST(ViewChoice, FramesTheFloorAroundTheStart) {
  const Report shown = view_test::solvedReport();
  const Subject subject = subjectOf(shown.levels.at(0), &shown.queries.at(0));
  // The floor is 10 studs wide and begins 5 studs behind the start.
  for (const Vec3 corner : {Vec3{-5, 0, 5}, Vec3{5, 0, 5}, Vec3{5, 0, -12}})
    EXPECT_NE(std::find(subject.frame.begin(), subject.frame.end(), corner), subject.frame.end());
}

TEST(ViewChoice, AHugeGroundIsNotFramed) {
  const auto place = [](const char* size) {
    return view_test::collect(
        {std::string(R"({"type":"level","name":"place","parts":[{"position":[0,-8,0],"size":)") +
         size + R"(},{"position":[40,2,0],"size":[4,4,4]},{"size":[12,1,12]}]})"});
  };
  const auto huge = place("[2048,16,2048]"), plain = place("[200,16,200]");
  ASSERT_TRUE(huge) << huge.error().text();
  ASSERT_TRUE(plain) << plain.error().text();
  EXPECT_EQ(courseOf(huge->levels[0]).hi.x, 42);
  EXPECT_EQ(courseOf(plain->levels[0]).hi.x, 100);
}

TEST(ViewChoice, ReadsFromLeftToRight) {
  const Subject subject = walkAlongX();
  const Vec3 look = bestLook(subject, {}, 640, 360);
  EXPECT_LT(look.z, 0) << "so that +x is on the right";
  EXPECT_LT(look.y, 0) << "from above";
}

TEST(ViewChoice, TheSubjectHasStartGoalAndTrajectory) {
  const Report shown = view_test::solvedReport();
  const Subject subject = subjectOf(shown.levels.at(0), &shown.queries.at(0));
  ASSERT_TRUE(subject.from && subject.to);
  Box box{subject.frame[0], subject.frame[0]};
  for (const Vec3 p : subject.frame) box = join(box, {p, p});
  for (const Vec3 p : subject.seen)
    EXPECT_TRUE(overlaps(grow(box, {0.01f, 2, 0.01f}), Box{p, p})) << p.x << " " << p.y;
  EXPECT_FALSE(subjectOf(shown.levels.at(0), nullptr).frame.empty());
}

}  // namespace
}  // namespace obby::view
