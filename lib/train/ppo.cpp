#include "train/ppo.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>

#include "policy/advantages.h"
#include "train/parts.h"

namespace obby::train {

namespace {

constexpr uint32_t kShares = 8;
constexpr size_t kRowsPerTile =
    256;  // decisions whose layers stay in a core's cache on their way through

// Sum of two draws' logarithm and cosine would need libm; the sum of twelve is near enough.
float normalDraw(Random& random) {
  float sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

// Orthogonal columns or rows, whichever are fewer, of length `gain`.
void fillOrthogonal(Rows<float>& matrix, int columns, float gain, Random& random) {
  const Eigen::Index rows = matrix.rows(), most = std::max<Eigen::Index>(rows, columns);
  const Eigen::Index least = std::min<Eigen::Index>(rows, columns);
  Eigen::MatrixXf draws(most, least);
  for (Eigen::Index i = 0; i < draws.size(); ++i) draws.data()[i] = normalDraw(random);
  const Eigen::HouseholderQR<Eigen::MatrixXf> qr(draws);
  const Eigen::MatrixXf q = qr.householderQ() * Eigen::MatrixXf::Identity(most, least);
  if (rows >= columns) {
    matrix.leftCols(columns) = gain * q;
  } else {
    matrix.leftCols(columns) = gain * q.transpose();
  }
}

}  // namespace

Weights<float> firstWeights(uint64_t seed) {
  Random random(seed, 0x50504f);
  Weights<float> weights;
  const float gain = std::sqrt(2.0f);
  fillOrthogonal(weights.w[0], policy::kHidden, gain, random);
  fillOrthogonal(weights.w[1], policy::kHidden, gain, random);
  fillOrthogonal(weights.w[2], policy::kMoves, 0.01f, random);
  Rows<float> value(policy::kHidden, 1);
  fillOrthogonal(value, 1, 1, random);
  weights.w[2].col(policy::kMoves) = value;
  return weights;
}

Ppo::Ppo(const PpoSettings& settings, uint64_t seed, ThreadPool& pool, Ranks& ranks)
    : settings_(settings),
      pool_(pool),
      ranks_(ranks),
      seed_(seed),
      weights_(firstWeights(seed)),
      shares_(kShares) {}

LearnerState Ppo::state() const { return {weights_, momentum_, squares_, adam_.steps(), values_}; }

void Ppo::restore(const LearnerState& s) {
  weights_ = s.weights;
  momentum_ = s.momentum;
  squares_ = s.squares;
  adam_ = policy::Adam(s.steps);
  values_ = s.values;
}

template <class Task>
void Ppo::inShares(size_t count, Task&& task) {
  const size_t each = (count + kShares - 1) / kShares;
  const auto share = [&](int s) {
    const size_t first = std::min(size_t(s) * each, count);
    task(first, std::min(each, count - first), shares_[size_t(s)]);
  };
  pool_.run(int(kShares), std::ref(share));  // by itself it would be copied to the heap
}

void Ppo::fillAdvantages(const Batch& b) {
  advantages_.resize(b.values.size());
  targets_.resize(b.values.size());
  const policy::Played played{b.ticks,          b.worlds,      b.values.data(),
                              b.rewards.data(), b.done.data(), b.last.data()};
  inShares(b.worlds, [&](size_t first, size_t count, Share&) {
    for (size_t w = first; w < first + count; ++w)
      policy::fillAdvantagesOf(played, uint32_t(w), settings_.discount, settings_.lambda,
                               advantages_.data(), targets_.data());
  });
}

void Ppo::rescaleValues() {
  inShares(targets_.size(), [&](size_t first, size_t count, Share& share) {
    share.returns = Sums(1);
    for (size_t i = first; i < first + count; ++i) share.returns.add(&targets_[i]);
  });
  Sums now(1);
  for (const Share& share : shares_) now.add(share.returns);
  const ValueScale old = values_;
  values_.take(std::move(now), ranks_);
  weights_.w[2].col(policy::kMoves) *= old.deviation / values_.deviation;
  float& bias = weights_.b[2](policy::kMoves);
  bias = (bias * old.deviation + old.mean - values_.mean) / values_.deviation;
}

Progress Ppo::learn(Batch& batch, float rate) {
  fillAdvantages(batch);
  rescaleValues();
  order_.resize(batch.decisions.size());
  inShares(order_.size(), [&](size_t first, size_t count, Share&) {
    for (size_t i = first; i < first + count; ++i)
      batch.decisions[i].target = (targets_[i] - values_.mean) / values_.deviation;
  });
  Progress sums;
  const Parts parts(uint32_t(order_.size()), settings_.part);
  for (uint32_t pass = 0; pass < settings_.passes; ++pass) {
    const Shuffle shuffle = orderOf(seed_, adam_.steps(), order_.size());
    inShares(order_.size(), [&](size_t first, size_t count, Share&) {
      for (size_t i = first; i < first + count; ++i) order_[i] = shuffle(uint32_t(i));
    });
    for (uint32_t i = 0; i < parts.count(); ++i)
      learnPart(batch, std::span(order_).subspan(parts.first(i), parts.size(i)), rate, sums);
  }
  sums.finish(order_.size() * settings_.passes, parts.count() * settings_.passes, ranks_);
  return sums;
}

void Progress::finish(size_t decisions, uint32_t parts, Ranks& ranks) {
  double all[] = {loss, entropy, divergence, clipped, valueError};
  ranks.add(all);
  const double* next = all;
  for (double* mean : {&loss, &entropy, &divergence, &clipped, &valueError})
    *mean = *next++ / (double(decisions) * ranks.count());
  norm /= parts;
}

AdvantageScale::AdvantageScale(double sum, double squares, double rows) : count(float(rows)) {
  const double average = sum / rows;
  const double deviation = std::sqrt(std::max(squares / rows - average * average, 0.0));
  mean = float(average);
  scale = float(1 / (deviation + 1e-8));
}

namespace {

// Makes the sum of `count` decisions' gradients their mean, no longer than `most`; how long it was.
// Squares are added as doubles, as on a GPU: as floats a network's thousands would cost two digits.
float meanCut(Weights<float>& gradient, float count, float most) {
  double squares = 0;
  for (int l = 0; l < 3; ++l) {
    gradient.w[l] /= count;
    gradient.b[l] /= count;
    squares += gradient.w[l].cast<double>().squaredNorm();
    squares += gradient.b[l].cast<double>().squaredNorm();
  }
  const float norm = std::sqrt(float(squares));
  if (norm <= most) return norm;
  for (int l = 0; l < 3; ++l) {
    gradient.w[l] *= most / norm;
    gradient.b[l] *= most / norm;
  }
  return norm;
}

}  // namespace

void Ppo::learnPart(const Batch& batch, std::span<const uint32_t> rows, float rate,
                    Progress& sums) {
  double sum = 0, squares = 0;
  for (const uint32_t r : rows) {
    sum += double(advantages_[r]);
    squares += double(advantages_[r]) * double(advantages_[r]);
  }
  double moments[] = {sum, squares, double(rows.size())};
  ranks_.add(moments);
  const AdvantageScale scale(moments[0], moments[1], moments[2]);
  back_.take(weights_);
  voidSums(batch.seen, weights_, void_);
  inShares(rows.size(), [&](size_t first, size_t count, Share& share) {
    learnShare(batch, rows.subspan(first, count), scale, share);
  });
  Weights<float>& all = shares_[0].gradient;
  for (uint32_t s = 0; s < kShares; ++s) {
    const Progress& p = shares_[s].sums;
    sums.loss += p.loss, sums.entropy += p.entropy, sums.divergence += p.divergence;
    sums.clipped += p.clipped, sums.valueError += p.valueError;
    if (s == 0) continue;
    for (int l = 0; l < 3; ++l) {
      all.w[l] += shares_[s].gradient.w[l];
      all.b[l] += shares_[s].gradient.b[l];
    }
  }
  addVoidSlopes(batch.seen, all);
  addRanks(all);
  sums.norm += double(meanCut(all, scale.count, settings_.mostNorm));
  step(all, settings_.rate * rate);
}

void Ppo::learnShare(const Batch& batch, std::span<const uint32_t> rows,
                     const AdvantageScale& scale, Share& share) const {
  share.gradient.setZero();
  share.sums = {};
  for (size_t first = 0; first < rows.size(); first += kRowsPerTile)
    learnTile(batch, rows.subspan(first, std::min(kRowsPerTile, rows.size() - first)), scale,
              share);
}

void Ppo::learnTile(const Batch& batch, std::span<const uint32_t> rows, const AdvantageScale& scale,
                    Share& share) const {
  const SeenPart inputs(batch.seen, rows, void_);
  share.slope.resize(Eigen::Index(rows.size()), policy::kPaddedOutputs);
  const Rows<float>& out = share.pass.forward(weights_, inputs);
  for (size_t i = 0; i < rows.size(); ++i) {
    if (i + kRowsAhead < rows.size()) {
      __builtin_prefetch(&batch.decisions[rows[i + kRowsAhead]]);
      __builtin_prefetch(&advantages_[rows[i + kRowsAhead]]);
    }
    Decision d = batch.decisions[rows[i]];
    d.advantage = (advantages_[rows[i]] - scale.mean) * scale.scale;
    const auto r = lossOf(out.row(Eigen::Index(i)).data(), d, settings_.loss,
                          share.slope.row(Eigen::Index(i)).data());
    share.sums.loss += double(r.loss);
    share.sums.entropy += double(r.entropy);
    share.sums.divergence += double(r.divergence);
    share.sums.clipped += r.clipped ? 1 : 0;
    share.sums.valueError += double(r.valueError * r.valueError);
  }
  share.pass.backward(back_, inputs, share.slope, share.gradient);
}

void Ppo::addRanks(Weights<float>& gradient) {
  if (ranks_.count() == 1) return;
  std::vector<float> flat = gradient.flat();
  ranks_.add(flat);
  gradient.setFlat(flat.data());
}

void Ppo::step(Weights<float>& gradient, float rate) {
  adam_.next();
  const auto update = [&](auto& w, auto& m, auto& v, const auto& g) {
    adam_.update(w.data(), g.data(), m.data(), v.data(), size_t(w.size()), rate);
  };
  for (int l = 0; l < 3; ++l) {
    update(weights_.w[l], momentum_.w[l], squares_.w[l], gradient.w[l]);
    update(weights_.b[l], momentum_.b[l], squares_.b[l], gradient.b[l]);
  }
}

}  // namespace obby::train
