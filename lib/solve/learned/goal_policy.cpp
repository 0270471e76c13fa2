#include "solve/learned/goal_policy.h"

#include <algorithm>

#include "policy/advantages.h"
#include "solve/learned/imitation_loss.h"

namespace obby::solve::learned {

namespace {

constexpr uint64_t kGoalPolicyStream = 0x50424745;  // of the seed's random numbers
constexpr size_t kIn = policy::kInputs, kGoalPolicyOut = policy::kPaddedOutputs,
                 kHidden = policy::kHidden;

}  // namespace

GoalPolicy::GoalPolicy(const GoalPolicySettings& settings, uint64_t seed, DeviceWork* device)
    : settings_(settings),
      random_(seed, kGoalPolicyStream),
      learner_({kIn, kHidden, kHidden, kGoalPolicyOut}, settings.learner) {
  fillRandom(learner_.net(), 0.01f, random_);
  for (Share& s : shares_) s.pass = NetPass(device);
}

void GoalPolicy::learn(ThreadPool& pool, const Decisions& d) {
  for (auto* v : {&advantages_, &targets_, &returns_, &unused_}) v->resize(d.rows());
  const policy::Played played{d.ticks,          d.players,     d.values.data(),
                              d.rewards.data(), d.done.data(), d.last.data()};
  policy::fillAdvantages(played, settings_.discount, settings_.lambda, advantages_.data(),
                         targets_.data());
  policy::fillAdvantages(played, settings_.discount, 1, unused_.data(), returns_.data());
  std::vector<uint32_t> order;
  for (uint32_t r = 0; r < d.rows(); ++r) {
    if (d.makers[r] != Maker::explorer) order.push_back(r);
  }
  for (uint32_t pass = 0; pass < settings_.passes; ++pass) {
    for (size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[random_.below(uint32_t(i))]);
    for (size_t first = 0; first < order.size(); first += settings_.part) {
      const size_t count = std::min<size_t>(settings_.part, order.size() - first);
      learnPart(pool, d, std::span(order).subspan(first, count));
    }
  }
}

void GoalPolicy::learnPart(ThreadPool& pool, const Decisions& d, std::span<const uint32_t> rows) {
  double sum = 0, squares = 0, count = 0;
  for (const uint32_t r : rows) {
    if (d.makers[r] != Maker::policy) continue;
    sum += double(advantages_[r]);
    squares += double(advantages_[r]) * double(advantages_[r]);
    count += 1;
  }
  const double mean = count > 0 ? sum / count : 0;
  const double variance = count > 0 ? squares / count - mean * mean : 0;
  const float scale = 1 / (sqrtf32(float(std::max(variance, 0.0))) + 1e-6f);
  forShares(pool, rows.size(), [&](size_t s, size_t first, size_t some) {
    learnShare(d, rows.subspan(first, some), float(mean), scale, s);
  });
  learner_.step(1 / float(rows.size()));
}

void GoalPolicy::learnShare(const Decisions& d, std::span<const uint32_t> rows, float mean,
                            float scale, size_t s) {
  Share& share = shares_[s];
  share.inputs.resize(rows.size() * kIn);
  share.slope.resize(rows.size() * kGoalPolicyOut);
  for (size_t i = 0; i < rows.size(); ++i)
    std::copy_n(d.inputs.data() + rows[i] * kIn, kIn, share.inputs.data() + i * kIn);
  const float* out = share.pass.forward(learner_.net(), share.inputs.data(), rows.size());
  for (size_t i = 0; i < rows.size(); ++i, out += kGoalPolicyOut) {
    const uint32_t r = rows[i];
    float* const slope = share.slope.data() + i * kGoalPolicyOut;
    policy::Decision made = d.made[r];
    if (d.makers[r] == Maker::kept) {
      made.target = returns_[r];
      imitationLoss(out, made, settings_.imitation, settings_.imitationValue, slope);
      continue;
    }
    made.advantage = (advantages_[r] - mean) * scale;
    made.target = targets_[r];
    float sharp[kGoalPolicyOut];
    for (size_t m = 0; m < kGoalPolicyOut; ++m)
      sharp[m] = m < policy::kMoves ? out[m] * d.sharpness[r] : out[m];
    policy::lossOf(sharp, made, settings_.loss, slope);
    for (int m = 0; m < policy::kMoves; ++m) slope[m] *= d.sharpness[r];
  }
  share.pass.backward(learner_.net(), share.inputs.data(), rows.size(), share.slope.data(),
                      learner_.gradient(s));
}

}  // namespace obby::solve::learned
