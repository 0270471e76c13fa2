// A run resumed from a checkpoint equals an uninterrupted run. A damaged checkpoint, or one of
// another run, is refused.
#include "train/checkpoint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "train/gaps.h"

namespace obby::train {
namespace {

using Trainers = Result<std::unique_ptr<Trainer>>;

// Returns the metrics of an iteration, without its times.
std::vector<double> figuresOf(const Iteration& i) {
  const Progress& p = i.progress;
  return {double(i.number), double(i.decisions), i.reward,     i.solved,
          double(i.played), double(i.hardest),   p.loss,       p.entropy,
          p.approxKl,       p.clipFraction,      p.valueError, p.gradNorm};
}

struct Learned {
  std::vector<std::vector<double>> figures;
  std::vector<float> numbers;  // parameters of the network
};

// Returns the results of iterations 4 to 6. If `broken`, the run is interrupted after the third and
// resumed.
Learned learn(const LevelSource& source, int threads, bool broken) {
  ThreadPool pool(threads);
  Trainers trainer = Trainer::make(small(), source, pool, alone());
  EXPECT_TRUE(trainer);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE((*trainer)->iterate());
  if (broken) {
    const std::string bytes = writeCheckpoint({"1", settingsOf(small()), 3, *(*trainer)->state()});
    *trainer = nullptr;
    auto read = readCheckpoint(bytes, "test");
    EXPECT_TRUE(read) << read.error().text();
    EXPECT_EQ(writeCheckpoint(*read), bytes);
    trainer = Trainer::resume(small(), source, pool, alone(), std::move(read->state));
    EXPECT_TRUE(trainer) << trainer.error().text();
  }
  Learned out;
  for (int i = 0; i < 3; ++i) out.figures.push_back(figuresOf(*(*trainer)->iterate()));
  out.numbers = (*trainer)->network().numbers();
  return out;
}

class Resuming : public testing::TestWithParam<bool> {};

TEST_P(Resuming, FromACheckpointHasTheSameBits) {
  const Gaps gaps(GetParam());
  const Learned whole = learn(gaps, 1, false);
  for (const int threads : {1, 2}) {
    const Learned broken = learn(gaps, threads, true);
    EXPECT_EQ(broken.figures, whole.figures) << threads;
    EXPECT_EQ(broken.numbers, whole.numbers) << threads;
  }
}

// Expects that an iteration is kept if the source stops or fails during it.
void resumeWithMissingLevels(bool bodies, bool fails) {
  ThreadPool pool(1);
  const Gaps gaps(bodies);
  const GapsTo stopped(12, bodies, fails);  // eight places
  const auto whole = Trainer::make(small(), gaps, pool, alone());
  const auto part = Trainer::make(small(), stopped, pool, alone());
  ASSERT_TRUE(whole && part);
  do {
    ASSERT_LT((*part)->iterations(), 100u);
    ASSERT_TRUE((*part)->more());
    ASSERT_TRUE((*whole)->iterate() && (*part)->iterate());
  } while (waitingIn(*(*part)->state()) == 0);
  EXPECT_EQ(bool((*part)->more()), !fails);
  if (fails) {
    EXPECT_EQ((*part)->iterate().error().text(), "this level is bad");
  }
  auto read = readCheckpoint(writeCheckpoint({"1", {}, 0, *(*part)->state()}), "test");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_FALSE(Trainer::resume(small(), stopped, pool, alone(), read->state));
  const auto resumed = Trainer::resume(small(), gaps, pool, alone(), std::move(read->state));
  ASSERT_TRUE(resumed) << resumed.error().text();
  for (int i = 0; i < 3; ++i) {
    const auto a = (*whole)->iterate(), b = (*resumed)->iterate();
    ASSERT_TRUE(a && b);
    EXPECT_EQ(figuresOf(*a), figuresOf(*b));
  }
  EXPECT_EQ((*whole)->network().numbers(), (*resumed)->network().numbers());
}

TEST_P(Resuming, AfterAStoppedSourceHasTheSameBits) { resumeWithMissingLevels(GetParam(), false); }

TEST_P(Resuming, AfterAFailedSourceHasTheSameBits) { resumeWithMissingLevels(GetParam(), true); }

INSTANTIATE_TEST_SUITE_P(WithAndWithoutDynamicBodies, Resuming, testing::Bool());

// Returns a checkpoint after a few iterations, so that all of its content differs from the initial
// state.
std::string sample() {
  ThreadPool pool(1);
  const Gaps gaps(true);
  TrainerSettings settings = small();
  settings.envGroups = 1;
  const auto trainer = Trainer::make(settings, gaps, pool, alone());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE((*trainer)->iterate());
  return writeCheckpoint({"1", settingsOf(settings), 3, *(*trainer)->state()});
}

TEST(Checkpoint, RemembersSolvedLevels) {
  ThreadPool pool(1);
  const Gaps gaps;
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  ASSERT_TRUE((*trainer)->iterate());
  TrainerState state = *(*trainer)->state();
  state.envGroups[0].places[0].counts.solvedOnce = 1;
  state.envGroups[0].places[1].counts.solvedOnce = 0;
  auto read = readCheckpoint(writeCheckpoint({"1", {}, 0, std::move(state)}), "test");
  ASSERT_TRUE(read) << read.error().text();
  const auto resumed = Trainer::resume(small(), gaps, pool, alone(), std::move(read->state));
  ASSERT_TRUE(resumed) << resumed.error().text();
  const TrainerState again = *(*resumed)->state();
  EXPECT_EQ(again.envGroups[0].places[0].counts.solvedOnce, 1u);
  EXPECT_EQ(again.envGroups[0].places[1].counts.solvedOnce, 0u);
}

TEST(Checkpoint, IsRefusedIfTruncated) {
  const std::string bytes = sample();
  ASSERT_TRUE(readCheckpoint(bytes, "whole"));
  for (size_t size = 0; size < bytes.size(); size += size < 256 ? 1 : 1016) {
    const auto read = readCheckpoint(std::string_view(bytes).substr(0, size), "short");
    ASSERT_FALSE(read) << size;
    EXPECT_EQ(read.error().input, "short");
    EXPECT_FALSE(read.error().hint.empty());
  }
}

TEST(Checkpoint, IsRefusedWithAnyBitFlipped) {
  std::string bytes = sample();
  for (size_t at = 0; at < bytes.size(); at += at < 512 ? 1 : 331) {
    const char old = bytes[at];
    bytes[at] = char(old ^ (1 << (at % 8)));
    EXPECT_FALSE(readCheckpoint(bytes, "flipped")) << at;
    bytes[at] = old;
  }
  EXPECT_FALSE(readCheckpoint(bytes + std::string(8, '\0'), "longer"));
  EXPECT_TRUE(readCheckpoint(bytes, "whole"));
}

TEST(Checkpoint, IsRefusedUnderOtherSettings) {
  const std::vector<Setting> then = settingsOf(small());
  EXPECT_TRUE(sameSettings(then, settingsOf(small())));
  TrainerSettings other = small();
  other.ppo.discount = 0.98f;
  const Status status = sameSettings(then, settingsOf(other));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "'discount' was 0.99 in the earlier run and is 0.98 now");
  std::vector<Setting> more = then;
  more.push_back({"style", "gaps"});
  EXPECT_FALSE(sameSettings(then, more));
  EXPECT_FALSE(sameSettings(more, then));
}

TEST(Checkpoint, SettingsOfEarlierVersionsHaveTheirPresentNames) {
  ThreadPool pool(1);
  const Gaps gaps;
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  std::vector<Setting> former = settingsOf(small());
  const auto rename = [&](const char* present, const char* old) {
    for (Setting& s : former)
      if (s.name == present) s.name = old;
  };
  rename("minibatch", "part");
  rename("epochs", "passes");
  rename("learning-rate", "rate");
  rename("max grad norm", "most norm");
  rename("env groups", "crowds");
  const auto read = readCheckpoint(writeCheckpoint({"1", former, 3, *(*trainer)->state()}), "test");
  ASSERT_TRUE(read) << read.error().text();
  const Status same = sameSettings(read->settings, settingsOf(small()));
  EXPECT_TRUE(same) << same.error().text();
}

TEST(Checkpoint, IsRefusedForOtherLevels) {
  ThreadPool pool(1);
  const Gaps gaps, others(false, 98), bodies(true);
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  ASSERT_TRUE((*trainer)->iterate());
  EXPECT_TRUE(Trainer::resume(small(), gaps, pool, alone(), *(*trainer)->state()));
  EXPECT_FALSE(Trainer::resume(small(), others, pool, alone(), *(*trainer)->state()));
  EXPECT_FALSE(Trainer::resume(small(), bodies, pool, alone(), *(*trainer)->state()));
}

// A checkpoint is refused if it contains an impossible number from which others are computed.
TEST(Checkpoint, IsRefusedWithImpossibleNumbers) {
  ThreadPool pool(1);
  const Gaps gaps;
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  ASSERT_TRUE((*trainer)->iterate());
  const auto refused = [&](auto&& spoil) {
    Checkpoint checkpoint{"1", {}, 0, *(*trainer)->state()};
    spoil(checkpoint.state);
    return !readCheckpoint(writeCheckpoint(checkpoint), "test");
  };
  EXPECT_FALSE(refused([](TrainerState&) {}));
  EXPECT_TRUE(refused([](TrainerState& s) { s.hardest = NAN; }));
  EXPECT_TRUE(refused([](TrainerState& s) { s.solved = 2; }));
  EXPECT_TRUE(refused([](TrainerState& s) { s.seen.rows = -1; }));
  EXPECT_TRUE(refused([](TrainerState& s) { s.learner.values.deviation = 0; }));
  EXPECT_TRUE(refused([](TrainerState& s) { s.learner.values.mean = INFINITY; }));
  EXPECT_TRUE(refused([](TrainerState& s) { s.envGroups[0].places[0].hardest = 1e9f; }));
  EXPECT_TRUE(refused([](TrainerState& s) { s.envGroups[0].places[0].nextHardest = -1; }));
}

// A checkpoint with a state that no env group of these levels can have is refused.
TEST(Checkpoint, IsRefusedWithImpossibleWorlds) {
  ThreadPool pool(1);
  const Gaps gaps(true);
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  ASSERT_TRUE((*trainer)->iterate());
  const auto refused = [&](auto&& spoil) {
    TrainerState state = *(*trainer)->state();
    spoil(state.envGroups[1].places[2]);
    return !Trainer::resume(small(), gaps, pool, alone(), std::move(state));
  };
  EXPECT_FALSE(refused([](PlaceState&) {}));
  EXPECT_TRUE(refused([](PlaceState& s) { s.players.pop_back(); }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.bodies.pop_back(); }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.taken = 0; }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.players[3].world.clockCount = 1; }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.players[3].world.clockCount = 200; }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.players[3].world.waypoints = 9; }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.players[3].world.position.x = NAN; }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.bodies[3].velocity.y = NAN; }));
  EXPECT_TRUE(refused([](PlaceState& s) { s.reached.resize(17, {s.players[0].world, 0}); }));
}

}  // namespace
}  // namespace obby::train
