#include "train/device/device_learner.h"

#include "nn/device/learn_kernels.h"
#include "train/device/kernels.h"

namespace obby::train {

Status DeviceBatch::make(sim::Device& device, uint32_t tickCount, uint32_t worldCount) {
  ticks = tickCount;
  worlds = worldCount;
  OBBY_RETURN_IF_ERROR(inputs.make(device, size_t(rows()) * policy::kInputs));
  OBBY_RETURN_IF_ERROR(decisions.make(device, rows()));
  for (auto* table : {&values, &rewards, &advantages, &returns})
    OBBY_RETURN_IF_ERROR(table->make(device, rows()));
  OBBY_RETURN_IF_ERROR(last.make(device, worlds));
  return done.make(device, rows());
}

Status DeviceLearner::make() {
  OBBY_RETURN_IF_ERROR(batch_.make(device_, settings_.ticks, settings_.worlds()));
  const nn::Network<float> net = firstNetwork(settings_.seed);
  const nn::Minibatches all = minibatches();
  const uint32_t rows = all.largest(), chunks = nn::chunksOf(rows);
  const size_t size = net.parameters().size();
  OBBY_RETURN_IF_ERROR(pass_.reserve(device_, net, std::max(rows, batch_.worlds), rows));
  OBBY_RETURN_IF_ERROR(adam_.make(device_, size));
  OBBY_RETURN_IF_ERROR(parameters_.make(device_, size));
  OBBY_RETURN_IF_ERROR(gradient_.make(device_, size));
  OBBY_RETURN_IF_ERROR(rows_.make(device_, size_t(rows) * policy::kInputs));
  OBBY_RETURN_IF_ERROR(figures_.make(device_, size_t(rows) * kFigures));
  OBBY_RETURN_IF_ERROR(figureChunks_.make(device_, size_t(chunks) * kFigures));
  OBBY_RETURN_IF_ERROR(totals_.makeZero(device_, kFigures + 1));
  OBBY_RETURN_IF_ERROR(everywhere_.make(device_, ranks_.count() > 1 ? size * ranks_.count() : 0));
  OBBY_RETURN_IF_ERROR(chunks_.make(device_, size_t(all.count()) * chunks));
  OBBY_RETURN_IF_ERROR(moments_.make(device_, all.count()));
  return parameters_.put(net.parameters());
}

Status DeviceLearner::restore(const LearnerState& s) {
  values_ = s.values;
  OBBY_RETURN_IF_ERROR(parameters_.put(s.parameters));
  return adam_.restore(s);
}

Result<LearnerState> DeviceLearner::state() const {
  OBBY_ASSIGN(nn::LearnerState learner, adam_.state());
  OBBY_ASSIGN(learner.parameters, parameters_.get());
  return LearnerState{std::move(learner), values_};
}

Status DeviceLearner::fillAdvantages() {
  const nn::AdvantageArguments a{{batch_.ticks, batch_.worlds, batch_.values.data(),
                                  batch_.rewards.data(), batch_.done.data(), batch_.last.data()},
                                 settings_.ppo.discount,
                                 settings_.ppo.lambda,
                                 batch_.advantages.data(),
                                 batch_.returns.data()};
  return enqueue(device_, nn::kernel(nn::Step::advantages), a, batch_.worlds);
}

// Returns the moments of each minibatch. Without a shuffle, the minibatches are ranges of
// consecutive rows, so that many threads have work.
Result<std::vector<nn::Moments>> DeviceLearner::moments(const float* values,
                                                        const Shuffle* shuffle) {
  const nn::MomentArguments m{values,
                              chunks_.data(),
                              moments_.data(),
                              shuffle != nullptr ? *shuffle : Shuffle(0, 0, batch_.rows()),
                              shuffle != nullptr,
                              minibatches()};
  OBBY_RETURN_IF_ERROR(
      enqueue(device_, nn::kernel(nn::Step::chunkMoments), m, moments_.size() * m.chunksOfEach()));
  OBBY_RETURN_IF_ERROR(enqueue(device_, nn::kernel(nn::Step::partMoments), m, moments_.size()));
  return moments_.get();
}

Result<nn::Moments> DeviceLearner::momentsOf(const float* table) {
  OBBY_ASSIGN(const auto parts, moments(table, nullptr));
  nn::Moments all;
  for (const nn::Moments& part : parts) all.add(part);
  return all;
}

Status DeviceLearner::rescaleValues() {
  OBBY_ASSIGN(const nn::Moments sums, momentsOf(batch_.returns.data()));
  Sums now(1);
  now.sum[0] = sums.sum;
  now.squares[0] = sums.squares;
  now.rows = double(batch_.rows());
  const ValueScale old = values_;
  values_.take(std::move(now), ranks_);
  const nn::Network<float> net = policy::trainableNetwork();
  const size_t last = net.layers() - 1;
  const RescaleArguments r{parameters_.data() + net.at(last),
                           parameters_.data() + net.biasesAt(last),
                           old.mean,
                           old.deviation,
                           values_.mean,
                           values_.deviation};
  return enqueue(device_, trainKernel(TrainStep::rescale), r, policy::kHidden);
}

// Returns sum, squares and count of each minibatch of an epoch, summed over all ranks.
Result<std::vector<double>> DeviceLearner::advantageMoments(const Shuffle& shuffle) {
  const nn::Minibatches all = minibatches();
  OBBY_ASSIGN(const auto mine, moments(batch_.advantages.data(), &shuffle));
  std::vector<double> sums;
  for (uint32_t i = 0; i < mine.size(); ++i)
    sums.insert(sums.end(), {mine[i].sum, mine[i].squares, double(all.size(i))});
  ranks_.add(sums);
  return sums;
}

Result<Progress> DeviceLearner::learn(float rate) {
  OBBY_RETURN_IF_ERROR(fillAdvantages());
  OBBY_RETURN_IF_ERROR(rescaleValues());
  OBBY_RETURN_IF_ERROR(totals_.clear());
  const PpoSettings& ppo = settings_.ppo;
  const nn::Minibatches all = minibatches();
  MinibatchArguments m{batch_.inputs.data(),
                       batch_.decisions.data(),
                       batch_.advantages.data(),
                       batch_.returns.data(),
                       Shuffle(0, 0, 1),
                       0,
                       0,
                       ppo.loss,
                       {},
                       values_.mean,
                       values_.deviation,
                       rows_.data(),
                       pass_.outputs(),
                       pass_.outputGradient(),
                       figures_.data()};
  for (uint32_t epoch = 0; epoch < ppo.epochs; ++epoch) {
    m.shuffle = orderOf(settings_.seed, adam_.steps(), batch_.rows());
    OBBY_ASSIGN(const auto sums, advantageMoments(m.shuffle));
    for (uint32_t i = 0; i < all.count(); ++i) {
      const double count = sums[3 * i + 2];
      m.first = all.first(i);
      m.count = all.size(i);
      m.scale = advantageScaleOf({sums[3 * i], sums[3 * i + 1]}, count);
      OBBY_RETURN_IF_ERROR(learnMinibatch(m));
      OBBY_RETURN_IF_ERROR(adam_.step(parameters_.data(), gradient_.data(), float(count),
                                      ppo.maxGradNorm, ppo.learningRate * rate,
                                      totals_.data() + kFigures));
    }
  }
  OBBY_ASSIGN(const std::vector<double> t, totals_.get());
  Progress out{t[kLossFigure],    t[kEntropyFigure], t[kApproxKlFigure],
               t[kClippedFigure], t[kValueFigure],   t[kFigures]};
  out.finish(size_t(batch_.rows()) * ppo.epochs, all.count() * ppo.epochs, ranks_);
  return out;
}

// Fills gradient_ with the sum over this minibatch on all ranks.
Status DeviceLearner::learnMinibatch(const MinibatchArguments& m) {
  OBBY_RETURN_IF_ERROR(
      enqueue(device_, trainKernel(TrainStep::gather), m, size_t(m.count) * kFoursOfRow));
  OBBY_RETURN_IF_ERROR(forward(m.rows, m.count));
  OBBY_RETURN_IF_ERROR(enqueue(device_, trainKernel(TrainStep::loss), m, m.count));
  OBBY_RETURN_IF_ERROR(pass_.backward(parameters_.data(), m.rows, m.count, gradient_.data()));
  const uint32_t chunks = nn::chunksOf(m.count);
  const nn::ColumnSumArguments figures{m.figures, figureChunks_.data(), m.count, kFigures};
  OBBY_RETURN_IF_ERROR(
      enqueue(device_, nn::kernel(nn::Step::sumColumns), figures, size_t(chunks) * kFigures));
  const nn::RowSumArguments sum{nullptr, figureChunks_.data(), nullptr, totals_.data(), chunks,
                                kFigures};
  OBBY_RETURN_IF_ERROR(enqueue(device_, nn::kernel(nn::Step::sumRows), sum, kFigures));
  return addRanks();
}

// Adds the gradients of all ranks in order, as Ranks::add does.
Status DeviceLearner::addRanks() {
  if (ranks_.count() == 1) return {};
  const auto size = uint32_t(gradient_.size());
  OBBY_RETURN_IF_ERROR(direct_.gather(device_, gradient_.data(), size, everywhere_.data()));
  const nn::RowSumArguments sum{everywhere_.data(), nullptr, gradient_.data(), nullptr,
                                ranks_.count(),     size};
  return enqueue(device_, nn::kernel(nn::Step::sumRows), sum, size);
}

}  // namespace obby::train
