#include "baselines/quantile_policy.h"

#include <algorithm>

#include "nn/losses.h"

namespace obby::baselines {

namespace {

constexpr uint64_t kQuantileStream = 0x51522d44514e;  // random stream
constexpr size_t kQuantileUnits = 64;                 // units per hidden layer
constexpr size_t kQuantileOut = size_t(policy::kMoves) * kQuantiles;

// Fills `to` with the inputs of a track's decision `i` toward `goal`.
void fillInputs(const Track& track, size_t i, const float* goal, float* to) {
  std::copy_n(track.inputs.data() + i * policy::kInputs, policy::kInputs, to);
  observeGoal(track.path->place(i), goal, to + policy::kInputs);
}

}  // namespace

void observeGoal(const float* place, const float* goal, float* out) {
  std::fill_n(out, kGoalInputs, 0.0f);
  for (size_t i = 0; i < kPlace; ++i) {
    const float apart = goal[i] - place[i];
    out[i] = clampf(apart, -2.0f, 2.0f);
    out[kPlace + i] = policy::squashed(apart, 2.0f);
  }
  static_assert(2 * kPlace <= kGoalInputs);
}

int bestMove(const float* quantiles, bool mayJump) {
  int best = 0;
  float most = 0;
  for (int m = 0; m < policy::kMoves; ++m, quantiles += kQuantiles) {
    if (!policy::isAllowed(m, mayJump)) continue;
    float sum = 0;
    for (size_t q = 0; q < kQuantiles; ++q) sum += quantiles[q];
    if (m > 0 && !(sum > most)) continue;
    best = m;
    most = sum;
  }
  return best;
}

QuantilePolicy::QuantilePolicy(const QuantileSettings& settings, uint64_t seed, DeviceWork* device)
    : settings_(settings),
      random_(seed, kQuantileStream),
      learner_(nn::Network<float>({kPolicyInputs, kQuantileUnits, kQuantileUnits, kQuantileOut}),
               kShares),
      target_(learner_.net()) {
  nn::fillUniform(learner_.net(), 0.01f, random_);
  target_ = learner_.net();
  for (Share& s : shares_) {
    for (NetPass* pass : {&s.pass, &s.next, &s.encoder}) *pass = NetPass(device);
  }
}

// Replaces the goal of most decisions by a place that the player reached later (hindsight).
void QuantilePolicy::draw(const Memory& memory, std::span<Lesson> lessons) {
  for (Lesson& l : lessons) {
    const auto [track, decision] = memory.at(random_.below(uint32_t(memory.size())));
    const uint32_t later = random_.below(uint32_t(track->decisions() - decision));
    const bool virtually = random_.unit() < settings_.hindsight;
    l = {track, decision,
         virtually ? track->path->place(decision + 1 + later)
                   : track->goals.data() + decision * kPlace};
  }
}

void QuantilePolicy::learn(ThreadPool& pool, const Memory& memory, const InverseDynamics& module) {
  if (steps_++ % settings_.refresh == 0) target_ = learner_.net();
  Lesson lessons[kBatch];
  draw(memory, lessons);
  nn::forShares(pool, kShares, kBatch, [&](size_t s, size_t first, size_t count) {
    learnShare(module, std::span(lessons).subspan(first, count), s);
  });
  learner_.step(settings_.learner, 1.0f / kBatch);
}

// A death costs as much as never reaching the goal.
void QuantilePolicy::learnShare(const InverseDynamics& module, std::span<const Lesson> lessons,
                                size_t s) {
  Share& share = shares_[s];
  const size_t count = lessons.size();
  share.inputs.resize(count * kPolicyInputs);
  share.nextInputs.resize(count * kPolicyInputs);
  share.places.resize(2 * count * kPlace);
  for (size_t i = 0; i < count; ++i) {
    const Lesson& l = lessons[i];
    fillInputs(*l.track, l.decision, l.goal, share.inputs.data() + i * kPolicyInputs);
    fillInputs(*l.track, l.decision + 1, l.goal, share.nextInputs.data() + i * kPolicyInputs);
    std::copy_n(l.track->path->place(l.decision + 1), kPlace, share.places.data() + 2 * i * kPlace);
    std::copy_n(l.goal, kPlace, share.places.data() + (2 * i + 1) * kPlace);
  }
  module.encode(share.places.data(), 2 * count, share.encoder, share.points);
  const float* points = share.points.data();
  const float* next = share.next.forward(target_, share.nextInputs.data(), count);
  const float* out = share.pass.forward(learner_.net(), share.inputs.data(), count);
  share.gradient.assign(count * kQuantileOut, 0.0f);
  for (size_t i = 0; i < count;
       ++i, points += 2 * kLatent, next += kQuantileOut, out += kQuantileOut) {
    const Lesson& l = lessons[i];
    const bool reached =
        latentDistance2(points, points + kLatent) < module.reach() * module.reach();
    const bool last = l.track->ended && l.decision + 1 == l.track->decisions();
    const int best = bestMove(next, l.track->mayJump[l.decision + 1] != 0);
    float targets[kQuantiles];
    for (size_t q = 0; q < kQuantiles; ++q) {
      const float later =
          last ? -1 / (1 - settings_.discount) : next[size_t(best) * kQuantiles + q];
      targets[q] = (reached ? 0.0f : -1.0f) + settings_.discount * later;
    }
    const size_t move = size_t(l.track->moves[l.decision]) * kQuantiles;
    nn::quantileLoss<kQuantiles>(out + move, targets,
                                 share.gradient.data() + i * kQuantileOut + move);
  }
  share.pass.backward(learner_.net(), share.inputs.data(), count, share.gradient.data(),
                      learner_.gradient(s));
}

}  // namespace obby::baselines
