#include "train/device/device_learner.h"

namespace obby::train {

Status DeviceBatch::make(sim::Device& device, uint32_t tickCount, uint32_t worldCount) {
  ticks = tickCount;
  worlds = worldCount;
  OBBY_RETURN_IF_ERROR(inputs.make(device, size_t(rows()) * policy::kInputs));
  OBBY_RETURN_IF_ERROR(decisions.make(device, rows()));
  for (auto* table : {&values, &rewards, &advantages, &targets})
    OBBY_RETURN_IF_ERROR(table->make(device, rows()));
  OBBY_RETURN_IF_ERROR(last.make(device, worlds));
  return done.make(device, rows());
}

Status DeviceLearner::make() {
  OBBY_RETURN_IF_ERROR(batch_.make(device_, settings_.ticks, settings_.worlds()));
  const Parts cut = partsOfPass();
  const uint32_t part = cut.largest(), chunks = chunksOf(part);
  OBBY_RETURN_IF_ERROR(network_.make(device_, std::max(part, batch_.worlds), part));
  const size_t size = network_.size();
  OBBY_RETURN_IF_ERROR(momentum_.makeZero(device_, size));
  OBBY_RETURN_IF_ERROR(squares_.makeZero(device_, size));
  OBBY_RETURN_IF_ERROR(rows_.make(device_, size_t(part) * policy::kInputs));
  OBBY_RETURN_IF_ERROR(figures_.make(device_, size_t(part) * kFigures));
  OBBY_RETURN_IF_ERROR(figureChunks_.make(device_, size_t(chunks) * kFigures));
  OBBY_RETURN_IF_ERROR(totals_.makeZero(device_, kFigures + 1));
  OBBY_RETURN_IF_ERROR(scale_.make(device_, 1));
  OBBY_RETURN_IF_ERROR(everywhere_.make(device_, ranks_.count() > 1 ? size * ranks_.count() : 0));
  OBBY_RETURN_IF_ERROR(chunks_.make(device_, size_t(cut.count()) * chunks));
  OBBY_RETURN_IF_ERROR(parts_.make(device_, cut.count()));
  OBBY_RETURN_IF_ERROR(squareChunks_.make(device_, chunksOf(uint32_t(size))));
  return network_.put(firstWeights(settings_.seed));
}

Status DeviceLearner::restore(const LearnerState& s) {
  OBBY_RETURN_IF_ERROR(network_.put(s.weights));
  OBBY_RETURN_IF_ERROR(momentum_.put(s.momentum.flat()));
  OBBY_RETURN_IF_ERROR(squares_.put(s.squares.flat()));
  adam_ = policy::Adam(s.steps);
  values_ = s.values;
  return {};
}

Result<LearnerState> DeviceLearner::state() const {
  LearnerState out;
  OBBY_ASSIGN(out.weights, network_.get());
  OBBY_ASSIGN(const std::vector<float> momentum, momentum_.get());
  OBBY_ASSIGN(const std::vector<float> squares, squares_.get());
  out.momentum.setFlat(momentum.data());
  out.squares.setFlat(squares.data());
  out.steps = adam_.steps();
  out.values = values_;
  return out;
}

Status DeviceLearner::fillAdvantages() {
  const AdvantageArguments a{{batch_.ticks, batch_.worlds, batch_.values.data(),
                              batch_.rewards.data(), batch_.done.data(), batch_.last.data()},
                             settings_.ppo.discount,
                             settings_.ppo.lambda,
                             batch_.advantages.data(),
                             batch_.targets.data()};
  return enqueue(device_, TrainStep::advantages, a, batch_.worlds);
}

Result<std::vector<Moments>> DeviceLearner::moments(const MomentArguments& m) {
  const uint32_t parts = m.parts.count();
  OBBY_RETURN_IF_ERROR(
      enqueue(device_, TrainStep::chunkMoments, m, size_t(parts) * m.chunksOfEach()));
  OBBY_RETURN_IF_ERROR(enqueue(device_, TrainStep::partMoments, m, parts));
  return sim::downloadTable(device_, m.out, parts);
}

// In parts, so that there is something to do for many threads.
Result<Moments> DeviceLearner::momentsOf(const float* table) {
  OBBY_ASSIGN(const auto parts, moments({table, chunks_.data(), parts_.data(),
                                         Shuffle(0, 0, batch_.rows()), false, partsOfPass()}));
  Moments all{0, 0};
  for (const Moments& part : parts) {
    all.sum += part.sum;
    all.squares += part.squares;
  }
  return all;
}

Status DeviceLearner::rescaleValues() {
  OBBY_ASSIGN(const Moments sums, momentsOf(batch_.targets.data()));
  Sums now(1);
  now.sum[0] = sums.sum;
  now.squares[0] = sums.squares;
  now.rows = double(batch_.rows());
  const ValueScale old = values_;
  values_.take(std::move(now), ranks_);
  const int last = DeviceNetwork::kLayers - 1;
  const RescaleArguments r{network_.matrix(last), network_.bias(last), old.mean,
                           old.deviation,         values_.mean,        values_.deviation};
  return enqueue(device_, TrainStep::rescale, r, policy::kHidden);
}

// Of the parts of a pass, by the advantages of all ranks.
Result<std::vector<AdvantageScale>> DeviceLearner::scalesOf(const Shuffle& shuffle) {
  const Parts cut = partsOfPass();
  OBBY_ASSIGN(const auto parts, moments({batch_.advantages.data(), chunks_.data(), parts_.data(),
                                         shuffle, true, cut}));
  std::vector<double> sums;
  for (uint32_t i = 0; i < parts.size(); ++i) {
    sums.insert(sums.end(), {parts[i].sum, parts[i].squares, double(cut.size(i))});
  }
  ranks_.add(sums);
  std::vector<AdvantageScale> out;
  for (size_t i = 0; i < sums.size(); i += 3) out.emplace_back(sums[i], sums[i + 1], sums[i + 2]);
  return out;
}

Result<Progress> DeviceLearner::learn(float rate) {
  OBBY_RETURN_IF_ERROR(fillAdvantages());
  OBBY_RETURN_IF_ERROR(rescaleValues());
  OBBY_RETURN_IF_ERROR(totals_.clear());
  const uint32_t rows = batch_.rows();
  const Parts cut = partsOfPass();
  for (uint32_t pass = 0; pass < settings_.ppo.passes; ++pass) {
    const Shuffle shuffle = orderOf(settings_.seed, adam_.steps(), rows);
    OBBY_ASSIGN(const auto scales, scalesOf(shuffle));
    for (uint32_t i = 0; i < scales.size(); ++i) {
      const PartArguments p{batch_.inputs.data(),
                            batch_.decisions.data(),
                            batch_.advantages.data(),
                            batch_.targets.data(),
                            shuffle,
                            cut.first(i),
                            cut.size(i),
                            settings_.ppo.loss,
                            scales[i].mean,
                            scales[i].scale,
                            values_.mean,
                            values_.deviation,
                            rows_.data(),
                            network_.outputs(),
                            network_.slopes(),
                            figures_.data()};
      OBBY_RETURN_IF_ERROR(learnPart(p, scales[i], settings_.ppo.rate * rate));
    }
  }
  OBBY_ASSIGN(const std::vector<double> t, totals_.get());
  Progress out{t[kLossFigure],    t[kEntropyFigure], t[kDivergenceFigure],
               t[kClippedFigure], t[kValueFigure],   t[kFigures]};
  out.finish(size_t(rows) * settings_.ppo.passes, cut.count() * settings_.ppo.passes, ranks_);
  return out;
}

Status DeviceLearner::learnPart(const PartArguments& p, const AdvantageScale& scale, float rate) {
  OBBY_RETURN_IF_ERROR(enqueue(device_, TrainStep::gather, p, size_t(p.count) * kFoursOfRow));
  OBBY_RETURN_IF_ERROR(network_.forward(p.rows, p.count));
  OBBY_RETURN_IF_ERROR(enqueue(device_, TrainStep::loss, p, p.count));
  OBBY_RETURN_IF_ERROR(network_.backward(p.rows, p.count));
  const uint32_t chunks = chunksOf(p.count);
  const ColumnSumArguments figures{p.figures, figureChunks_.data(), p.count, kFigures};
  OBBY_RETURN_IF_ERROR(enqueue(device_, TrainStep::sumColumns, figures, size_t(chunks) * kFigures));
  const RowSumArguments sum{nullptr, figureChunks_.data(), nullptr, totals_.data(), chunks,
                            kFigures};
  OBBY_RETURN_IF_ERROR(enqueue(device_, TrainStep::sumRows, sum, kFigures));
  OBBY_RETURN_IF_ERROR(addRanks());
  return step(scale.count, rate);
}

// In the order of their numbers, as Ranks::add does.
Status DeviceLearner::addRanks() {
  if (ranks_.count() == 1) return {};
  const auto size = uint32_t(network_.size());
  OBBY_RETURN_IF_ERROR(direct_.gather(device_, network_.gradient(), size, everywhere_.data()));
  const RowSumArguments sum{everywhere_.data(), nullptr, network_.gradient(), nullptr,
                            ranks_.count(),     size};
  return enqueue(device_, TrainStep::sumRows, sum, size);
}

Status DeviceLearner::step(float decisions, float rate) {
  adam_.next();
  const auto size = uint32_t(network_.size());
  const StepArguments s{network_.weights(),
                        momentum_.data(),
                        squares_.data(),
                        network_.gradient(),
                        size,
                        decisions,
                        squareChunks_.data(),
                        settings_.ppo.mostNorm,
                        adam_.at(rate),
                        scale_.data(),
                        totals_.data() + kFigures};
  OBBY_RETURN_IF_ERROR(enqueue(device_, TrainStep::squares, s, chunksOf(size)));
  OBBY_RETURN_IF_ERROR(enqueue(device_, TrainStep::scale, s, 1));
  return enqueue(device_, TrainStep::move, s, size);
}

}  // namespace obby::train
