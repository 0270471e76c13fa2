#include "train/ppo.h"

#include <algorithm>

#include "nn/minibatches.h"
#include "nn/orthogonal.h"

namespace obby::train {

namespace {

constexpr size_t kShares = 8;
constexpr size_t kRowsPerTile = 256;  // decisions whose activations fit in a core's cache

}  // namespace

nn::Network<float> firstNetwork(uint64_t seed) {
  Random random(seed, 0x50504f);
  nn::Network<float> net = policy::trainableNetwork();
  std::vector<float>& parameters = net.parameters();
  const auto fill = [&](size_t l, size_t first, size_t columns, float gain) {
    nn::fillOrthogonal(parameters.data() + net.at(l) + first, net.inputs(l), columns,
                       net.outputs(l), gain, random);
  };
  const float gain = sqrtf32(2.0f);
  fill(0, 0, policy::kHidden, gain);
  fill(1, 0, policy::kHidden, gain);
  fill(2, 0, policy::kMoves, 0.01f);
  fill(2, policy::kMoves, 1, 1);  // the value head
  return net;
}

Ppo::Ppo(const PpoSettings& settings, uint64_t seed, ThreadPool& pool, Ranks& ranks)
    : settings_(settings),
      pool_(pool),
      ranks_(ranks),
      seed_(seed),
      learner_(firstNetwork(seed), kShares),
      shares_(kShares) {}

void Ppo::restore(const LearnerState& state) {
  learner_.restore(state);
  values_ = state.values;
}

template <class Task>
void Ppo::inShares(size_t count, Task&& task) {
  nn::forShares(pool_, kShares, count,
                [&](size_t s, size_t first, size_t some) { task(first, some, s); });
}

void Ppo::fillAdvantages(const Batch& b) {
  advantages_.resize(b.values.size());
  returns_.resize(b.values.size());
  const nn::Rollout rollout{b.ticks,          b.worlds,      b.values.data(),
                            b.rewards.data(), b.done.data(), b.last.data()};
  inShares(b.worlds, [&](size_t first, size_t count, size_t) {
    for (size_t w = first; w < first + count; ++w)
      nn::fillAdvantagesOf(rollout, uint32_t(w), settings_.discount, settings_.lambda,
                           advantages_.data(), returns_.data());
  });
}

void Ppo::rescaleValues() {
  inShares(returns_.size(), [&](size_t first, size_t count, size_t s) {
    shares_[s].returns = Sums(1);
    for (size_t i = first; i < first + count; ++i) shares_[s].returns.add(&returns_[i]);
  });
  Sums now(1);
  for (const Share& share : shares_) now.add(share.returns);
  const ValueScale old = values_;
  values_.take(std::move(now), ranks_);
  nn::Network<float>& net = learner_.net();
  const size_t last = net.layers() - 1;
  float* const weight = net.parameters().data() + net.at(last) + policy::kMoves;
  for (size_t i = 0; i < net.inputs(last); ++i)
    weight[i * net.outputs()] *= old.deviation / values_.deviation;
  float& bias = net.parameters()[net.biasesAt(last) + policy::kMoves];
  bias = (bias * old.deviation + old.mean - values_.mean) / values_.deviation;
}

Progress Ppo::learn(Batch& batch, float rate) {
  fillAdvantages(batch);
  rescaleValues();
  order_.resize(batch.decisions.size());
  inShares(order_.size(), [&](size_t first, size_t count, size_t) {
    for (size_t i = first; i < first + count; ++i)
      batch.decisions[i].target = (returns_[i] - values_.mean) / values_.deviation;
  });
  Progress sums;
  const nn::Minibatches minibatches(uint32_t(order_.size()), settings_.minibatch);
  for (uint32_t epoch = 0; epoch < settings_.epochs; ++epoch) {
    const Shuffle shuffle = orderOf(seed_, learner_.steps(), order_.size());
    inShares(order_.size(), [&](size_t first, size_t count, size_t) {
      for (size_t i = first; i < first + count; ++i) order_[i] = shuffle(uint32_t(i));
    });
    for (uint32_t i = 0; i < minibatches.count(); ++i) {
      const std::span<const uint32_t> order = order_;
      learnMinibatch(batch, order.subspan(minibatches.first(i), minibatches.size(i)), rate, sums);
    }
  }
  sums.finish(order_.size() * settings_.epochs, minibatches.count() * settings_.epochs, ranks_);
  return sums;
}

void Progress::add(const nn::PpoLoss<float>& r) {
  loss += double(r.loss);
  entropy += double(r.entropy);
  approxKl += double(r.approxKl);
  clipFraction += r.clipped ? 1 : 0;
  valueError += double(r.valueError * r.valueError);
}

void Progress::add(const Progress& sums) {
  loss += sums.loss, entropy += sums.entropy, approxKl += sums.approxKl;
  clipFraction += sums.clipFraction, valueError += sums.valueError;
}

void Progress::finish(size_t decisions, uint32_t minibatches, Ranks& ranks) {
  double all[] = {loss, entropy, approxKl, clipFraction, valueError};
  ranks.add(all);
  const double* next = all;
  for (double* mean : {&loss, &entropy, &approxKl, &clipFraction, &valueError})
    *mean = *next++ / (double(decisions) * ranks.count());
  gradNorm /= minibatches;
}

void Ppo::learnMinibatch(const Batch& batch, std::span<const uint32_t> rows, float rate,
                         Progress& sums) {
  nn::Moments m;
  for (const uint32_t r : rows) m.add(double(advantages_[r]));
  double moments[] = {m.sum, m.squares, double(rows.size())};
  ranks_.add(moments);
  const nn::AdvantageScale scale = advantageScaleOf({moments[0], moments[1]}, moments[2]);
  voidSums(batch.seen, net(), void_);
  inShares(rows.size(), [&](size_t first, size_t count, size_t s) {
    shares_[s].sums = {};
    for (size_t done = 0; done < count; done += kRowsPerTile)
      learnTile(batch, rows.subspan(first + done, std::min(kRowsPerTile, count - done)), scale,
                shares_[s], learner_.gradient(s));
  });
  for (const Share& share : shares_) sums.add(share.sums);
  std::vector<float>& gradient = learner_.sumShares();
  addVoidGradients(batch.seen, net(), gradient);
  ranks_.add(gradient);
  for (float& g : gradient) g /= float(moments[2]);
  // Adds squares as doubles, as on a GPU. Thousands of floats would lose two digits.
  sums.gradNorm += double(nn::clipGradNorm<double>(gradient, settings_.maxGradNorm));
  learner_.step(settings_.learningRate * rate);
}

void Ppo::learnTile(const Batch& batch, std::span<const uint32_t> rows,
                    const nn::AdvantageScale& scale, Share& share, std::vector<float>& gradient) {
  constexpr size_t kOutputs = policy::kPaddedOutputs;
  const SeenPart inputs(batch.seen, rows, void_);
  share.gradient.resize(kRowsPerTile * kOutputs);
  const float* const out = share.pass.forward(net(), inputs);
  for (size_t i = 0; i < rows.size(); ++i) {
    if (i + kRowsAhead < rows.size()) {
      __builtin_prefetch(&batch.decisions[rows[i + kRowsAhead]]);
      __builtin_prefetch(&advantages_[rows[i + kRowsAhead]]);
    }
    Decision d = batch.decisions[rows[i]];
    d.advantage = scale(advantages_[rows[i]]);
    share.sums.add(policy::ppoLossOf(out + i * kOutputs, d, settings_.loss,
                                     share.gradient.data() + i * kOutputs));
  }
  share.pass.backward(net(), inputs, share.gradient.data(), gradient);
}

}  // namespace obby::train
