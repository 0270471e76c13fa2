#include "baselines/goal_policy.h"

#include <algorithm>

#include "policy/trainable.h"

namespace obby::baselines {

namespace {

constexpr uint64_t kGoalPolicyStream = 0x50424745;  // random stream
constexpr size_t kIn = policy::kInputs, kGoalPolicyOut = policy::kPaddedOutputs;

}  // namespace

GoalPolicy::GoalPolicy(const GoalPolicySettings& settings, uint64_t seed, DeviceWork* device)
    : settings_(settings),
      random_(seed, kGoalPolicyStream),
      learner_(policy::trainableNetwork(), kShares) {
  nn::fillUniform(learner_.net(), 0.01f, random_);
  for (Share& s : shares_) s.pass = NetPass(device);
}

void GoalPolicy::learn(ThreadPool& pool, const Decisions& d) {
  for (auto* v : {&advantages_, &targets_, &returns_, &unused_}) v->resize(d.rows());
  const nn::Rollout rollout{d.ticks,          d.players,     d.values.data(),
                            d.rewards.data(), d.done.data(), d.last.data()};
  nn::fillAdvantages(rollout, settings_.discount, settings_.lambda, advantages_.data(),
                     targets_.data());
  nn::fillAdvantages(rollout, settings_.discount, 1, unused_.data(), returns_.data());
  std::vector<uint32_t> order;
  for (uint32_t r = 0; r < d.rows(); ++r) {
    if (d.makers[r] != Maker::explorer) order.push_back(r);
  }
  for (uint32_t epoch = 0; epoch < settings_.epochs; ++epoch) {
    for (size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[random_.below(uint32_t(i))]);
    for (size_t first = 0; first < order.size(); first += settings_.minibatch) {
      const size_t count = std::min<size_t>(settings_.minibatch, order.size() - first);
      learnMinibatch(pool, d, std::span(order).subspan(first, count));
    }
  }
}

void GoalPolicy::learnMinibatch(ThreadPool& pool, const Decisions& d,
                                std::span<const uint32_t> rows) {
  nn::Moments moments;
  double count = 0;
  for (const uint32_t r : rows) {
    if (d.makers[r] != Maker::policy) continue;
    moments.add(double(advantages_[r]));
    count += 1;
  }
  const nn::AdvantageScale scale = nn::advantageScale(moments, count, 1e-6f);
  nn::forShares(pool, kShares, rows.size(), [&](size_t s, size_t first, size_t some) {
    learnShare(d, rows.subspan(first, some), scale, s);
  });
  learner_.step(settings_.learner, 1 / float(rows.size()));
}

void GoalPolicy::learnShare(const Decisions& d, std::span<const uint32_t> rows,
                            const nn::AdvantageScale& scale, size_t s) {
  Share& share = shares_[s];
  share.inputs.resize(rows.size() * kIn);
  share.gradient.resize(rows.size() * kGoalPolicyOut);
  for (size_t i = 0; i < rows.size(); ++i)
    std::copy_n(d.inputs.data() + rows[i] * kIn, kIn, share.inputs.data() + i * kIn);
  const float* out = share.pass.forward(learner_.net(), share.inputs.data(), rows.size());
  for (size_t i = 0; i < rows.size(); ++i, out += kGoalPolicyOut) {
    const uint32_t r = rows[i];
    float* const gradient = share.gradient.data() + i * kGoalPolicyOut;
    policy::Decision made = d.made[r];
    if (d.makers[r] == Maker::kept) {
      made.target = returns_[r];
      policy::imitationLossOf(out, made, settings_.imitation, settings_.imitationValue, gradient);
      continue;
    }
    made.advantage = scale(advantages_[r]);
    made.target = targets_[r];
    float sharp[kGoalPolicyOut];
    for (size_t m = 0; m < kGoalPolicyOut; ++m)
      sharp[m] = m < policy::kMoves ? out[m] * d.sharpness[r] : out[m];
    policy::ppoLossOf(sharp, made, settings_.loss, gradient);
    for (int m = 0; m < policy::kMoves; ++m) gradient[m] *= d.sharpness[r];
  }
  share.pass.backward(learner_.net(), share.inputs.data(), rows.size(), share.gradient.data(),
                      learner_.gradient(s));
}

}  // namespace obby::baselines
