#include "train/device/device_engine.h"

#include "train/device/device_learner.h"
#include "train/device/device_places.h"
#include "train/device/kernels.h"

namespace obby::train {

namespace {

class DeviceEngine : public Engine {
 public:
  DeviceEngine(const TrainerSettings& settings, const LevelSource& source, sim::Device& device,
               ThreadPool& pool, Ranks& ranks, DeviceRanks* direct)
      : settings_(settings),
        device_(device),
        through_(ranks),
        learner_(settings, device, ranks, direct != nullptr ? *direct : through_),
        places_(settings, source, device, pool, ranks.number(), ranks.count()) {}

  Status begin(float hardest) override {
    OBBY_RETURN_IF_ERROR(make());
    return places_.begin(hardest);
  }
  Status restore(const LearnerState& learner, std::span<EnvGroupState> envGroups) override {
    OBBY_RETURN_IF_ERROR(make());
    OBBY_RETURN_IF_ERROR(learner_.restore(learner));
    return places_.restore(envGroups);
  }
  Status setLearner(const LearnerState& learner) override { return learner_.restore(learner); }
  Result<Played> play(const PlayOrder& order) override;
  Result<Progress> learn(float rate) override { return learner_.learn(rate); }
  Result<LearnerState> learner() const override { return learner_.state(); }
  Result<std::vector<EnvGroupState>> envGroups() const override { return places_.state(); }

 private:
  Status make();
  PlayArguments argumentsOf(const PlayOrder& order) const;
  void pointTo(PlayArguments& a, uint32_t tick);
  Status look(const PlayArguments& a, bool count);
  Status act(const PlayArguments& a);
  Status playTicks(PlayArguments& a);
  Result<Sums> seen() const;

  TrainerSettings settings_;
  sim::Device& device_;
  HostRanks through_;
  DeviceLearner learner_;
  DevicePlaces places_;
  sim::DeviceTable<float> means_, scales_, spare_;  // spare: (worlds, kInputs), last observation
  sim::DeviceTable<double> sums_, squares_;         // (env groups, kInputs)
};

Status DeviceEngine::make() {
  if (settings_.envGroup.observe != EnvGroupSettings().observe)
    return makeError(
        "the GPU supports only the standard observation, but the settings name another one",
        "train on the CPU");
  OBBY_RETURN_IF_ERROR(learner_.make());
  OBBY_RETURN_IF_ERROR(means_.make(device_, policy::kInputs));
  OBBY_RETURN_IF_ERROR(scales_.make(device_, policy::kInputs));
  OBBY_RETURN_IF_ERROR(spare_.make(device_, size_t(settings_.worlds()) * policy::kInputs));
  OBBY_RETURN_IF_ERROR(sums_.make(device_, size_t(settings_.envGroups) * policy::kInputs));
  return squares_.make(device_, size_t(settings_.envGroups) * policy::kInputs);
}

PlayArguments DeviceEngine::argumentsOf(const PlayOrder& order) const {
  PlayArguments a{};
  places_.describe(a);
  a.reward = settings_.envGroup.reward;
  a.rules = {settings_.seed, settings_.envGroup.restarts, order.iteration * settings_.ticks, false};
  a.means = means_.data();
  a.scales = scales_.data();
  a.valueMean = learner_.values().mean;
  a.valueDeviation = learner_.values().deviation;
  a.sums = sums_.data();
  a.squares = squares_.data();
  a.worldsOfEnvGroup = settings_.envGroup.size();
  return a;
}

// Points `a` to the batch's rows of a tick.
void DeviceEngine::pointTo(PlayArguments& a, uint32_t tick) {
  DeviceBatch& b = learner_.batch();
  const size_t first = size_t(tick) * b.worlds;
  a.inputs = b.inputs.data() + first * policy::kInputs;
  a.outputs = learner_.outputs();
  a.decisions = b.decisions.data() + first;
  a.values = b.values.data() + first;
  a.rewards = b.rewards.data() + first;
  a.done = b.done.data() + first;
}

// Observes all worlds and runs the network on the observations.
Status DeviceEngine::look(const PlayArguments& a, bool count) {
  OBBY_RETURN_IF_ERROR(enqueue(device_, trainKernel(TrainStep::observe), a,
                               size_t(a.worlds) * policy::kViewThreads));
  if (count)
    OBBY_RETURN_IF_ERROR(enqueue(device_, trainKernel(TrainStep::countInputs), a, sums_.size()));
  OBBY_RETURN_IF_ERROR(
      enqueue(device_, trainKernel(TrainStep::normalise), a, size_t(a.worlds) * policy::kInputs));
  return learner_.forward(a.inputs, a.worlds);
}

// Worlds with dynamic bodies are few but take as long as all others, so both run concurrently.
Status DeviceEngine::act(const PlayArguments& a) {
  if (!places_.anyBodies()) return enqueue(device_, trainKernel(TrainStep::act), a, a.worlds);
  return device_.enqueueTogether(trainKernel(TrainStep::act), trainKernel(TrainStep::actDynamic),
                                 &a, a.worlds);
}

Status DeviceEngine::playTicks(PlayArguments& a) {
  const size_t places = size_t(settings_.envGroups) * settings_.envGroup.levels;
  for (uint32_t t = 0; t < settings_.ticks; ++t) {
    pointTo(a, t);
    OBBY_RETURN_IF_ERROR(look(a, t % kCountEvery == 0));
    OBBY_RETURN_IF_ERROR(act(a));
    if (t + 1 == settings_.ticks) break;
    OBBY_RETURN_IF_ERROR(enqueue(device_, trainKernel(TrainStep::settle), a, places));
    ++a.rules.decision;
  }
  a.inputs = spare_.data();
  a.values = learner_.batch().last.data();
  OBBY_RETURN_IF_ERROR(look(a, false));
  OBBY_RETURN_IF_ERROR(enqueue(device_, trainKernel(TrainStep::expect), a, a.worlds));
  a.rules.endOfIteration = true;
  return enqueue(device_, trainKernel(TrainStep::settle), a, places);
}

Result<Played> DeviceEngine::play(const PlayOrder& order) {
  OBBY_RETURN_IF_ERROR(means_.put(order.means));
  OBBY_RETURN_IF_ERROR(scales_.put(order.scales));
  OBBY_RETURN_IF_ERROR(sums_.clear());
  OBBY_RETURN_IF_ERROR(squares_.clear());
  PlayArguments a = argumentsOf(order);
  OBBY_RETURN_IF_ERROR(playTicks(a));
  Played out;
  OBBY_ASSIGN(out.tally, places_.endIteration(order.hardest, a));
  out.missing = places_.missing();
  OBBY_ASSIGN(out.seen, seen());
  OBBY_ASSIGN(const nn::Moments rewards, learner_.momentsOf(learner_.batch().rewards.data()));
  out.reward = rewards.sum;
  return out;
}

// Adds up the env groups in order, as on the CPU.
Result<Sums> DeviceEngine::seen() const {
  OBBY_ASSIGN(const std::vector<double> sums, sums_.get());
  OBBY_ASSIGN(const std::vector<double> squares, squares_.get());
  Sums out(policy::kInputs);
  for (size_t i = 0; i < sums.size(); ++i) {
    out.sum[i % policy::kInputs] += sums[i];
    out.squares[i % policy::kInputs] += squares[i];
  }
  const uint32_t counted = (settings_.ticks + kCountEvery - 1) / kCountEvery;
  out.rows = double(counted) * settings_.worlds();
  return out;
}

}  // namespace

std::unique_ptr<Engine> makeDeviceEngine(const TrainerSettings& settings, const LevelSource& source,
                                         sim::Device& device, ThreadPool& pool, Ranks& ranks,
                                         DeviceRanks* direct) {
  return std::make_unique<DeviceEngine>(settings, source, device, pool, ranks, direct);
}

std::unique_ptr<Engine> makeEngine(const TrainerSettings& settings, const LevelSource& source,
                                   sim::Device* device, ThreadPool& pool, Ranks& ranks,
                                   DeviceRanks* direct) {
  if (device == nullptr) return makeCpuEngine(settings, source, pool, ranks);
  return makeDeviceEngine(settings, source, *device, pool, ranks, direct);
}

}  // namespace obby::train
