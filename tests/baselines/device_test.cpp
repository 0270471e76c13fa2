// Methods that learn while they search give the same bytes on the CPU and on a device, even if the
// device fails midway. Tests networks forward and backward, observations, and whole searches.
#include <gtest/gtest.h>

#include "baselines/cflge.h"
#include "baselines/pbge.h"
#include "solve/resident_scenes.h"
#include "solve/scenes.h"
#include "support/failing_device.h"
#include "support/hasty.h"

namespace obby::baselines {
namespace {

std::vector<float> drawn(size_t count, Random& random) {
  std::vector<float> v(count);
  for (float& x : v) x = 2 * random.unit() - 1;
  return v;
}

// A network with its inputs and output gradients.
struct Rows {
  explicit Rows(size_t count) : rows(count), random(5, count), net({16, 64, 32, 48}) {
    net.parameters() = drawn(net.parameters().size(), random);
    inputs = drawn(rows * 16, random);
    gradient = drawn(rows * 48, random);
  }
  // Returns the outputs, the gradients of the parameters, and the gradients of the inputs, in this
  // order.
  std::vector<float> through(NetPass& pass) const {
    const float* const out = pass.forward(net, inputs.data(), rows);
    std::vector<float> result(out, out + rows * 48);
    std::vector<float> sums(net.parameters().size()), inputGradient(inputs.size());
    pass.backward(net, inputs.data(), rows, gradient.data(), sums, inputGradient.data());
    result.insert(result.end(), sums.begin(), sums.end());
    result.insert(result.end(), inputGradient.begin(), inputGradient.end());
    return result;
  }

  size_t rows;
  Random random;
  nn::Network<float> net;
  std::vector<float> inputs, gradient;
};

DeviceWork workOn(sim::Device& device, const Problem& problem) {
  static const policy::SurroundingsView nothing{};
  return {device, problem, nothing, 4};
}

TEST(NetPass, EqualsTheCpuBitForBitOnADevice) {
  const level::Level level = steppingStones().compile();
  const Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  DeviceWork work = workOn(device, problem);
  NetPass here, there(&work);
  Rows none(0), one(1), many(64), some(7);
  for (Rows* r : {&none, &one, &many, &some}) {  // later networks reuse the memory
    EXPECT_TRUE(r->through(there) == r->through(here)) << r->rows;
    r->net.parameters()[3] += 1;  // the change must reach the device
    EXPECT_TRUE(r->through(there) == r->through(here)) << r->rows;
  }
  EXPECT_TRUE(work.works());
}

TEST(NetPass, ContinuesOnTheCpuIfTheDeviceFails) {
  const level::Level level = steppingStones().compile();
  const Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  // The forward pass has three launches, the backward pass twelve.
  for (int launches = 0; launches <= 15; ++launches) {
    support::FailingDevice device(pool, launches);
    DeviceWork work = workOn(device, problem);
    NetPass here, there(&work);
    const Rows r(20);
    EXPECT_TRUE(r.through(there) == r.through(here)) << launches;
    EXPECT_EQ(work.works(), launches == 15) << launches;
    EXPECT_TRUE(r.through(there) == r.through(here)) << launches;
  }
}

template <class S>
void expectSameSearch(const S& a, const S& b) {
  ASSERT_EQ(a.cellCount(), b.cellCount());
  EXPECT_EQ(a.statistics().steps, b.statistics().steps);
  EXPECT_EQ(a.statistics().rollouts, b.statistics().rollouts);
  EXPECT_EQ(a.returns().tried, b.returns().tried);
  EXPECT_EQ(a.returns().reached, b.returns().reached);
  EXPECT_EQ(a.bytesKept(), b.bytesKept());
  EXPECT_EQ(a.archive().seen(), b.archive().seen());
  for (uint32_t c = 0; c < a.cellCount(); ++c) {
    ASSERT_EQ(sim::stateHash(a.archive().world(c), a.archive().bodies(c)),
              sim::stateHash(b.archive().world(c), b.archive().bodies(c)))
        << c;
  }
}

template <class S, class Settings>
void expectTheSameOnADevice(const Problem& problem, int rounds, const char* name) {
  SCOPED_TRACE(name);
  const Settings settings = support::hasty(Settings{});
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  S here(problem, 3, settings, pool), there(problem, 3, settings, {pool, &device});
  for (int round = 0; round < rounds; ++round) {
    here.round();
    there.round();
  }
  EXPECT_TRUE(there.deviceStatus());
  EXPECT_GT(here.cellCount(), 5u);
  EXPECT_GT(here.returns().tried, 0u);  // the learned policy played
  expectSameSearch(here, there);
}

// The smallest difference would make trajectories diverge.
TEST(LearnedDevice, SearchesAreTheSameCellByCell) {
  for (const auto& [name, scene] : residentScenes()) {
    const Problem problem = scene->asked.problem();
    const int rounds = problem.level.bodyCount != 0 ? 3 : 6;  // dynamic bodies make searches slow
    expectTheSameOnADevice<Pbge, PbgeSettings>(problem, rounds, name);
    expectTheSameOnADevice<Cflge, CflgeSettings>(problem, rounds, name);
  }
}

// Expects the same search wherever the device fails: in the observation, a layer, two ticks of a
// decision, the learning, and later rounds. A round of play takes 228 launches in PBGE and 160 in
// CFLGE. CFLGE takes hundreds more to learn from the first round on.
template <class S, class Settings>
void expectTheSameWhereverItFails() {
  constexpr int kRounds = 6;
  const level::Level level = support::movingArena(40, 8, 3).compile();
  const Problem problem = support::endlessProblem(level);
  const Settings settings = support::hasty(Settings{});
  ThreadPool pool(2);
  S here(problem, 3, settings, pool);
  for (int round = 0; round < kRounds; ++round) here.round();
  for (const int launches : {0, 1, 4, 6, 250, 301, 1'010, 1'302}) {
    SCOPED_TRACE(launches);
    support::FailingDevice device(pool, launches);
    S there(problem, 3, settings, {pool, &device});
    for (int round = 0; round < kRounds; ++round) there.round();
    EXPECT_FALSE(there.deviceStatus());
    expectSameSearch(here, there);
  }
}

TEST(LearnedDevice, AFailingDeviceIsGivenUpAndTheSearchIsTheSame) {
  expectTheSameWhereverItFails<Pbge, PbgeSettings>();
  expectTheSameWhereverItFails<Cflge, CflgeSettings>();
}

}  // namespace
}  // namespace obby::baselines
