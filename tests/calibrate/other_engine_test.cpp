// Recordings by an independent engine. A fit to some of them predicts other recordings of the same
// player. bench/calibrate.cpp tests this more strictly.
#include <gtest/gtest.h>

#ifdef OBBY_HAS_BULLET_PLAYER

#include "calibrate/course.h"
#include "calibrate/fit.h"
#include "support/bullet_player.h"
#include "support/level_builder.h"
#include "support/recording_faults.h"
#include "support/varied_manoeuvre.h"

namespace obby::calibrate {
namespace {

std::vector<Take> played(const test::BulletGame& game, const std::vector<Manoeuvre>& manoeuvres) {
  io::RecordBuilder course;
  test::writeBulletCourse(course.root().initLevel());
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

// A player may hit parts from the side, from below and at corners. Parts may stop or turn the
// player, but must not throw it.
TEST(OtherEngine, NoPlayerIsThrown) {
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const auto game = test::drawnGame(test::BulletGame::Body::kinematic, seed, 0.25f);
    std::vector<Manoeuvre> shown = test::bulletManoeuvres();
    uint64_t variant = 100 * seed + 50;
    for (Manoeuvre& m : shown) m = test::varied(m, ++variant, test::kAgain);
    for (const Take& take : played(game, shown)) {
      const auto& frames = take.track.frames;
      for (size_t i = 1; i < frames.size(); ++i) {
        Vec3 gone = frames[i].position - frames[i - 1].position;
        gone.y = 0;
        EXPECT_LT(length(gone), game.walkSpeed / 60 + 0.15f) << seed << " " << take.track.name << i;
      }
    }
  }
}

// A player that holds jump under a ceiling jumps only off the floor.
TEST(OtherEngine, ACeilingIsNoFloor) {
  support::LevelBuilder low;
  low.block({0, -0.5f, 0}, {40, 1, 40}).block({0, 7.5f, 0}, {40, 1, 40});
  const auto level = low.compile();
  const test::BulletGame game;
  const Track track =
      test::playedByBullet(game, level, {"low", {0, 0.1f, 0}, {{0.5f, 0, 0}, {2, 0, 0, true}}});
  for (size_t i = 2; i < track.frames.size(); ++i) {
    const auto height = [&](size_t k) { return track.frames[k].position.y; };
    const bool rose = height(i - 1) > height(i - 2), rises = height(i) > height(i - 1) + 1e-3f;
    EXPECT_TRUE(rose || !rises || height(i - 1) < 3.5f) << "off the ceiling, frame " << i;
  }
}

TEST(OtherEngine, IsPredictedOnceFittedTo) {
  const auto game = test::drawnGame(test::BulletGame::Body::kinematic, 1, 0.25f);
  std::vector<Manoeuvre> shown = firstManoeuvres(3), others;
  for (const Manoeuvre& m : shown) others.push_back(test::varied(m, 10 + others.size()));
  const std::vector<Take> takes = played(game, shown), heldOut = played(game, others);
  const auto parameters =
      *parametersNamed({"walkSpeed", "traction", "airAccel", "gravity", "jumpSpeed", "hipHeight",
                        "hoverStiffness", "hoverDamping"},
                       defaults());
  FitSettings settings;
  settings.restarts = 1;
  settings.generations = 40;
  settings.tolerance = 0.1;
  ThreadPool pool(availableThreads());
  const std::atomic<bool> stop{false};
  const auto found =
      fit(takes, parameters, defaults(), settings, pool, stop, [](const FitProgress&) {});
  ASSERT_TRUE(found) << found.error().text();
  io::RecordBuilder params;
  params.root().initParams();
  for (const Fitted& f : found->parameters)
    setValue(params.root().getParams(), f.parameter.name, f.value);
  params.root().getParams().setControlRate(uint16_t(found->controlRate));
  params.root().getParams().setSubsteps(uint16_t(found->substeps));
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
