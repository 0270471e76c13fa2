// Recordings by an engine that nobody here wrote: a fit to them predicts others of the same player.
// bench/calibrate.cpp asks more of it.
#include <gtest/gtest.h>

#ifdef OBBY_HAS_BULLET_PLAYER

#include "calibrate/course.h"
#include "calibrate/fit.h"
#include "support/bullet_player.h"
#include "support/recording_faults.h"
#include "support/varied_manoeuvre.h"

namespace obby::calibrate {
namespace {

std::vector<Take> played(const test::BulletGame& game, const std::vector<Manoeuvre>& manoeuvres) {
  io::RecordBuilder course;
  writeCourse(course.root().initLevel());
  const auto level = level::Level::compile(course.reader().getLevel());
  const io::Record record(std::move(course));
  std::vector<Take> out;
  for (const Manoeuvre& m : manoeuvres) {
    const Track track = test::playedByBullet(game, *level, m);
    out.push_back({test::spoiled(track, {.noise = 0.01f}, out.size()), record});
  }
  return out;
}

double meanMissOf(const std::vector<Take>& takes, schema::PhysicsParams::Reader params,
                  double delay) {
  double sum = 0;
  for (const Take& take : takes) sum += missOf(*pathOf(take, params, delay)).mean;
  return sum / double(takes.size());
}

TEST(OtherEngine, IsPredictedOnceFittedTo) {
  const auto game = test::drawnGame(test::BulletGame::Body::kinematic, 1, 0.25f);
  std::vector<Manoeuvre> shown = firstManoeuvres(3), others;
  for (const Manoeuvre& m : shown) others.push_back(test::varied(m, 10 + others.size()));
  const std::vector<Take> takes = played(game, shown), heldOut = played(game, others);
  const auto parameters =
      *parametersNamed({"walkSpeed", "groundAccel", "airAccel", "gravity", "jumpSpeed", "hipHeight",
                        "hoverStiffness", "hoverDamping"},
                       defaults());
  FitSettings settings;
  settings.restarts = 1;
  settings.generations = 40;
  settings.tolerance = 0.1;
  ThreadPool pool(availableThreads());
  const std::atomic<bool> stop{false};
  const auto found =
      fit(takes, parameters, defaults(), settings, pool, stop, [](uint32_t, uint32_t, double) {});
  ASSERT_TRUE(found) << found.error().text();
  io::RecordBuilder params;
  params.root().initParams();
  for (const Fitted& f : found->parameters)
    setValue(params.root().getParams(), f.parameter.name, f.value);
  const auto fitted = params.reader().getParams();
  EXPECT_GT(meanMissOf(heldOut, defaults(), 0), 1) << "it is another game";
  EXPECT_LT(meanMissOf(heldOut, fitted, found->delay), 0.1);
  EXPECT_NEAR(fitted.getWalkSpeed(), game.walkSpeed, 0.01 * game.walkSpeed);
}

}  // namespace
}  // namespace obby::calibrate

#else

TEST(OtherEngine, IsPredictedOnceFittedTo) { GTEST_SKIP() << "built without libbullet-dev"; }

#endif
