// Training with kernels equals training on the CPU. Worlds and random numbers have the same bits,
// and networks differ only by rounding. The CPU stands in for the GPU.
#include "train/device/device_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <new>

#include "sim/host_device.h"
#include "sim/simulator.h"
#include "support/failing_device.h"
#include "train/checkpoint.h"
#include "train/evaluate.h"
#include "train/gaps.h"
#include "train/thread_ranks.h"

namespace obby::train {
namespace {

using Trainers = Result<std::unique_ptr<Trainer>>;

// A device with its own thread pool.
struct Machine {
  explicit Machine(int threads = 1) : pool(threads), device(pool) {}

  Trainers make(const LevelSource& source, const TrainerSettings& settings = small(),
                Ranks& ranks = alone()) {
    return Trainer::make(settings, makeDeviceEngine(settings, source, device, pool, ranks), ranks);
  }
  Trainers resume(const LevelSource& source, TrainerState state,
                  const TrainerSettings& settings = small()) {
    Ranks& ranks = alone();
    return Trainer::resume(settings, makeDeviceEngine(settings, source, device, pool, ranks), ranks,
                           std::move(state));
  }

  ThreadPool pool;
  sim::HostDevice device;
};

struct Difference {
  uint32_t worlds = 0, different = 0;
};

Difference differenceOf(const TrainerState& a, const TrainerState& b) {
  Difference out;
  for (size_t c = 0; c < a.envGroups.size(); ++c) {
    for (size_t p = 0; p < a.envGroups[c].places.size(); ++p) {
      const PlaceState &one = a.envGroups[c].places[p], &other = b.envGroups[c].places[p];
      for (size_t i = 0; i < one.players.size(); ++i) {
        const Player &x = one.players[i], &y = other.players[i];
        const bool same = stateHash(x.world) == stateHash(y.world) && x.minLeft == y.minLeft &&
                          x.ticks == y.ticks && x.fromStart == y.fromStart;
        out.different += !same;
        ++out.worlds;
      }
    }
  }
  return out;
}

// Compares all values of two places that involve no rounding.
void expectSamePlaces(const TrainerState& a, const TrainerState& b) {
  ASSERT_EQ(a.envGroups.size(), b.envGroups.size());
  for (size_t c = 0; c < a.envGroups.size(); ++c) {
    ASSERT_EQ(a.envGroups[c].places.size(), b.envGroups[c].places.size());
    for (size_t p = 0; p < a.envGroups[c].places.size(); ++p) {
      const PlaceState &x = a.envGroups[c].places[p], &y = b.envGroups[c].places[p];
      EXPECT_EQ(x.taken, y.taken);
      EXPECT_EQ(x.hardest, y.hardest);
      EXPECT_EQ(x.nextHardest, y.nextHardest);
      EXPECT_EQ(x.levelHash, y.levelHash);
      EXPECT_EQ(x.counts.played, y.counts.played);
      EXPECT_EQ(x.counts.solvedOnce, y.counts.solvedOnce);
      ASSERT_EQ(x.reached.size(), y.reached.size());
      for (size_t i = 0; i < x.reached.size(); ++i) {
        EXPECT_EQ(stateHash(x.reached[i].world), stateHash(y.reached[i].world));
        EXPECT_EQ(x.reached[i].minLeft, y.reached[i].minLeft);
      }
      ASSERT_EQ(x.bodies.size(), y.bodies.size());
      EXPECT_TRUE(x.bodies.empty() || std::memcmp(x.bodies.data(), y.bodies.data(),
                                                  x.bodies.size() * sizeof x.bodies[0]) == 0);
    }
  }
}

double farthest(const std::vector<float>& a, const std::vector<float>& b) {
  double max = 0;
  for (size_t i = 0; i < a.size(); ++i) max = std::max(max, std::abs(double(a[i]) - double(b[i])));
  return max;
}

double farApart(const std::vector<float>& a, const std::vector<float>& b) {  // the mean weight
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::abs(double(a[i]) - double(b[i]));
  return sum / double(a.size());
}

class Parity : public testing::TestWithParam<bool> {};

// Both networks are equal in the first iteration, so all worlds make the same moves, unless a
// random number falls between two roundings of a probability. Afterwards the networks agree within
// rounding.
TEST_P(Parity, TheFirstIterationMatches) {
  const Gaps gaps(GetParam());
  ThreadPool pool(1);
  const auto cpu = Trainer::make(small(), gaps, pool, alone());
  Machine machine;
  const auto gpu = machine.make(gaps);
  ASSERT_TRUE(gpu) << gpu.error().text();
  EXPECT_EQ((*cpu)->network().numbers(), (*gpu)->network().numbers());
  const auto here = (*cpu)->iterate(), there = (*gpu)->iterate();
  ASSERT_TRUE(there) << there.error().text();
  const TrainerState a = *(*cpu)->state(), b = *(*gpu)->state();
  const Difference d = differenceOf(a, b);
  EXPECT_EQ(d.worlds, small().worlds());
  EXPECT_EQ(d.different, 0u);
  expectSamePlaces(a, b);
  EXPECT_EQ(a.seen.sum, b.seen.sum) << "the observations";
  EXPECT_EQ(a.seen.squares, b.seen.squares);
  EXPECT_EQ(a.seen.rows, b.seen.rows);
  EXPECT_NEAR(here->reward, there->reward, 1e-9);
  EXPECT_EQ(here->played, there->played);
  EXPECT_EQ(here->solved, there->solved);
  EXPECT_EQ(here->decisions, there->decisions);
  EXPECT_NEAR(here->progress.loss, there->progress.loss, 1e-5);
  EXPECT_NEAR(here->progress.entropy, there->progress.entropy, 1e-5);
  EXPECT_NEAR(here->progress.approxKl, there->progress.approxKl, 1e-5);
  EXPECT_NEAR(here->progress.clipFraction, there->progress.clipFraction, 1e-3);
  EXPECT_NEAR(here->progress.valueError, there->progress.valueError, 1e-5);
  EXPECT_NEAR(here->progress.gradNorm / there->progress.gradNorm, 1, 1e-6);  // some 15
  EXPECT_NEAR(a.learner.values.mean, b.learner.values.mean, 1e-6);
  EXPECT_NEAR(a.learner.values.deviation, b.learner.values.deviation, 1e-6);
  EXPECT_EQ(a.learner.steps, b.learner.steps);
  // A decision at the edge of the clip range may fall on either side, which moves some weights.
  EXPECT_LT(farApart(a.learner.parameters, b.learner.parameters), 1e-7);
  EXPECT_LT(farthest(a.learner.parameters, b.learner.parameters), 2e-4);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutDynamicBodies, Parity, testing::Bool());

// Plays many levels without training, with episodes that end or are truncated. A world whose random
// number falls between two roundings of a probability would differ. Expect one in about 200 runs.
TEST_P(Parity, PlayThroughManyLevelsMatches) {
  const Gaps gaps(GetParam());
  TrainerSettings settings = small();
  settings.ppo.learningRate = 0;
  settings.envGroup.episodes = 24;
  settings.envGroup.patience = -5;  // cuts episodes after about four seconds
  ThreadPool pool(1);
  const auto cpu = Trainer::make(settings, gaps, pool, alone());
  Machine machine;
  const auto gpu = machine.make(gaps, settings);
  uint64_t played = 0;
  for (int i = 0; i < 8; ++i) {
    const auto here = (*cpu)->iterate(), there = (*gpu)->iterate();
    ASSERT_TRUE(here && there);
    EXPECT_NEAR(here->reward, there->reward, 1e-4);
    EXPECT_EQ(here->played, there->played);
    played += here->played;
  }
  const TrainerState a = *(*cpu)->state(), b = *(*gpu)->state();
  EXPECT_EQ(differenceOf(a, b).different, 0u);
  expectSamePlaces(a, b);
  EXPECT_EQ(a.seen.sum, b.seen.sum);
  EXPECT_GT(played, 2u * settings.worlds());
  for (const EnvGroupState& envGroup : a.envGroups) {
    for (const PlaceState& place : envGroup.places) EXPECT_GT(place.taken, 2u);
  }
}

// Each iteration starts from the CPU's network with Adam's moments, because learners that differ by
// rounding soon diverge. A decision between two roundings of the clip range moves some weights by a
// few hundred thousandths. A random number between two roundings of a probability, as in about one
// of a hundred runs, moves the mean weight by less than 1e-4.
TEST(DeviceEngine, EachIterationLearnsWhatTheCpuDoes) {
  const Gaps gaps;
  ThreadPool pool(1);
  const auto cpu = Trainer::make(small(), gaps, pool, alone());
  Machine machine;
  for (int i = 0; i < 8; ++i) {
    const auto gpu = machine.resume(gaps, *(*cpu)->state());
    ASSERT_TRUE(gpu) << gpu.error().text();
    const auto here = (*cpu)->iterate(), there = (*gpu)->iterate();
    ASSERT_TRUE(there) << there.error().text();
    const TrainerState a = *(*cpu)->state(), b = *(*gpu)->state();
    const uint32_t different = differenceOf(a, b).different;
    EXPECT_LE(different, 1u) << i;
    const bool same = different == 0;
    EXPECT_NEAR(here->reward, there->reward, same ? 1e-9 : 1e-3) << i;
    EXPECT_NEAR(here->progress.entropy, there->progress.entropy, same ? 1e-5 : 1e-3) << i;
    EXPECT_LT(farApart(a.learner.parameters, b.learner.parameters), same ? 1e-6 : 1e-4) << i;
  }
}

TEST(DeviceEngine, TheBitsDoNotDependOnTheNumberOfThreads) {
  const Gaps gaps(true);
  std::vector<float> expected;
  for (const int threads : {1, 3}) {
    Machine machine(threads);
    const auto trainer = machine.make(gaps, tiny());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE((*trainer)->iterate());
    const std::vector<float> numbers = (*trainer)->network().numbers();
    if (expected.empty()) expected = numbers;
    EXPECT_EQ(numbers, expected) << threads;
  }
}

TEST(DeviceEngine, MinibatchesHaveEqualSizes) {
  const Gaps gaps;
  const uint32_t rows = tiny().ticks * tiny().worlds();
  const auto learned = [&](uint32_t minibatch) {
    TrainerSettings settings = tiny();
    settings.ppo.minibatch = minibatch;
    Machine machine;
    const auto trainer = machine.make(gaps, settings);
    EXPECT_TRUE((*trainer)->iterate());
    return (*trainer)->network().numbers();
  };
  EXPECT_EQ(learned(rows - 1), learned(rows / 2));
}

TEST(DeviceEngine, LearnsToCrossAGap) {
  const Gaps gaps;
  Machine machine(2);
  const auto trainer = machine.make(gaps);
  for (int i = 0; i < 30; ++i) ASSERT_TRUE((*trainer)->iterate());
  EvaluationSettings how;
  how.levels = 50;
  how.firstLevel = 1'000'000;
  const std::atomic<bool> stop{false};
  const Evaluation learned = evaluate((*trainer)->network(), gaps, how, machine.pool, stop);
  EXPECT_GT(learned.drawn, 0.9);
}

TEST(DeviceEngine, AResumedRunHasTheSameBits) {
  for (const bool bodies : {false, true}) {
    const Gaps gaps(bodies);
    Machine machine, other;
    const auto whole = machine.make(gaps, tiny());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE((*whole)->iterate());
    const std::string bytes = writeCheckpoint({"1", {}, 0, *(*whole)->state()});
    auto read = readCheckpoint(bytes, "test");
    ASSERT_TRUE(read) << read.error().text();
    const auto broken = other.resume(gaps, std::move(read->state), tiny());
    ASSERT_TRUE(broken) << broken.error().text();
    for (int i = 0; i < 3; ++i) {
      const auto a = (*whole)->iterate(), b = (*broken)->iterate();
      ASSERT_TRUE(a && b);
      EXPECT_EQ(a->reward, b->reward);
      EXPECT_EQ(a->progress.loss, b->progress.loss);
    }
    EXPECT_EQ((*whole)->network().numbers(), (*broken)->network().numbers());
    const TrainerState a = *(*whole)->state(), b = *(*broken)->state();
    EXPECT_EQ(differenceOf(a, b).different, 0u);
    expectSamePlaces(a, b);
  }
}

TEST(DeviceEngine, AResumedRunWithMissingLevelsHasTheSameBits) {
  for (const bool bodies : {false, true}) {
    const Gaps gaps(bodies);
    const GapsTo stopped(12, bodies, !bodies);  // eight places
    TrainerSettings settings = tiny();
    settings.envGroup.episodes = 16;  // few, since tiny() has few worlds
    Machine machine, other, third;
    const auto whole = machine.make(gaps, settings), part = other.make(stopped, settings);
    ASSERT_TRUE(whole && part);
    do {
      ASSERT_LT((*part)->iterations(), 100u);
      ASSERT_TRUE((*whole)->iterate() && (*part)->iterate());
    } while (waitingIn(*(*part)->state()) == 0);
    EXPECT_EQ(bool((*part)->more()), bodies) << "it stopped or failed";
    const auto resumed = third.resume(gaps, *(*part)->state(), settings);
    ASSERT_TRUE(resumed) << resumed.error().text();
    for (int i = 0; i < 3; ++i) ASSERT_TRUE((*whole)->iterate() && (*resumed)->iterate());
    EXPECT_EQ((*whole)->network().numbers(), (*resumed)->network().numbers());
    const TrainerState a = *(*whole)->state(), b = *(*resumed)->state();
    EXPECT_EQ(differenceOf(a, b).different, 0u);
    expectSamePlaces(a, b);
  }
}

TEST(DeviceEngine, RefusesTheStateOfOtherLevels) {
  const Gaps gaps, others(false, 98);
  Machine machine;
  const auto trainer = machine.make(gaps, tiny());
  ASSERT_TRUE((*trainer)->iterate());
  EXPECT_TRUE(machine.resume(gaps, *(*trainer)->state(), tiny()));
  EXPECT_FALSE(machine.resume(others, *(*trainer)->state(), tiny()));
  TrainerState spoilt = *(*trainer)->state();
  spoilt.envGroups[1].places[2].players[3].world.position.x = NAN;
  EXPECT_FALSE(machine.resume(gaps, std::move(spoilt), tiny()));
}

TEST(DeviceEngine, TrainsWithOtherRanks) {
  const Gaps gaps;
  std::vector<float> learned[2], again;
  for (auto* first : {&learned[0], &again}) {
    ThreadRanks::run(2, [&](Ranks& ranks) {
      Machine machine;
      const auto trainer = machine.make(gaps, tiny(), ranks);
      ASSERT_TRUE(trainer) << trainer.error().text();
      for (int i = 0; i < 2; ++i) ASSERT_TRUE((*trainer)->iterate());
      (ranks.first() ? *first : learned[1]) = (*trainer)->network().numbers();
    });
  }
  EXPECT_EQ(learned[0], learned[1]) << "every rank has the same network";
  EXPECT_EQ(learned[0], again);
  Machine machine;
  const auto one = machine.make(gaps, tiny());
  for (int i = 0; i < 2; ++i) ASSERT_TRUE((*one)->iterate());
  EXPECT_NE((*one)->network().numbers(), learned[0]);
}

TEST(DeviceEngine, ReturnsTheErrorOfTheDevice) {
  const Gaps gaps;
  ThreadPool pool(1);
  for (const int launches : {0, 5, 400}) {
    support::FailingDevice device(pool, launches);
    const auto trainer =
        Trainer::make(tiny(), makeDeviceEngine(tiny(), gaps, device, pool, alone()), alone());
    Status status = trainer ? Status() : Status(trainer.error());
    for (int i = 0; i < 3 && status; ++i) {
      const auto iteration = (*trainer)->iterate();
      if (!iteration) status = iteration.error();
    }
    ASSERT_FALSE(status) << launches;
    EXPECT_EQ(status.error().text(), "CUDA: rollout: unspecified launch failure");
  }
}

TEST(DeviceEngine, RefusesAnotherObservation) {
  const Gaps gaps;
  Machine machine;
  TrainerSettings settings = tiny();
  settings.envGroup.observe = [](const policy::Scene&, const sim::World&, const sim::RigidBody*,
                                 float*) { return Turns(0); };
  const auto trainer = machine.make(gaps, settings);
  ASSERT_FALSE(trainer);
  EXPECT_EQ(trainer.error().message,
            "the GPU supports only the standard observation, but the settings name another one");
}

// Levels, one of which is bad.
class OneBad : public Gaps {
 public:
  explicit OneBad(uint64_t bad) : bad_(bad) {}
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    if (index == bad_) return makeError("this level is bad");
    return Gaps::level(index, hardest);
  }

 private:
  uint64_t bad_;
};

// A level that is made ahead may never be played. Its error is returned only once it is played.
TEST(DeviceEngine, ReturnsTheErrorOfALevelOnceItIsPlayed) {
  Machine machine;
  const OneBad first(5), second(8 + 5);  // eight places play the levels
  EXPECT_EQ(machine.make(first, tiny()).error().text(), "this level is bad");
  TrainerSettings settings = tiny();
  settings.envGroup.episodes = 32;  // with 8 worlds, no level is finished after one iteration
  const auto trainer = machine.make(second, settings);
  ASSERT_TRUE(trainer) << trainer.error().text();
  ASSERT_TRUE((*trainer)->iterate());
  Status status;
  for (int i = 0; i < 40 && status; ++i) {
    const auto iteration = (*trainer)->iterate();
    if (!iteration) status = iteration.error();
  }
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().text(), "this level is bad");
}

// Levels, one of which needs more memory than the machine has.
class OneTooLarge : public Gaps {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    if (index == 9) throw std::bad_alloc();  // the second level of its place
    return Gaps::level(index, hardest);
  }
};

// Levels are made on another thread, where an uncaught exception would end the process.
TEST(DeviceEngine, ThrowsTheExceptionOfMakingALevel) {
  const OneTooLarge gaps;
  TrainerSettings settings = tiny();
  settings.envGroup.episodes = 16;
  for (const int threads : {1, 2}) {
    Machine machine(threads);
    const auto trainer = machine.make(gaps, settings);
    ASSERT_TRUE(trainer) << trainer.error().text();
    const auto learn = [&] {
      for (int i = 0; i < 40; ++i) ASSERT_TRUE((*trainer)->iterate());
    };
    EXPECT_THROW(learn(), std::bad_alloc) << threads;
  }
}

}  // namespace
}  // namespace obby::train
