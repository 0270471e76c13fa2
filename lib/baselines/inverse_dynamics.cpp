#include "baselines/inverse_dynamics.h"

#include <algorithm>

#include "policy/decision.h"

namespace obby::baselines {

namespace {

constexpr uint64_t kDynamicsStream = 0x4c4745;  // random stream
constexpr size_t kDynamicsUnits = 64;           // units per hidden layer
constexpr size_t kDynamicsOut = nn::padded(policy::kMoves);
constexpr float kApart = 1000;    // exceeds all distances in latent space
constexpr float kFollow = 0.02f;  // weight of the newest mean distance
constexpr nn::LearnerSettings kSettings{.learningRate = 1e-3f, .weightDecay = 1e-5f};

nn::Network<float> netOf(size_t inputs, size_t outputs) {
  return nn::Network<float>({inputs, kDynamicsUnits, kDynamicsUnits, outputs});
}

}  // namespace

InverseDynamics::InverseDynamics(uint64_t seed, DeviceWork* device)
    : random_(seed, kDynamicsStream),
      encoder_(netOf(kPlace, kLatent), kShares),
      head_(netOf(2 * kLatent, kDynamicsOut), kShares) {
  nn::fillUniform(encoder_.net(), 1, random_);
  nn::fillUniform(head_.net(), 0.1f, random_);
  for (Share& s : shares_) {
    for (NetPass* pass : {&s.encoder, &s.head}) *pass = NetPass(device);
  }
}

float InverseDynamics::learn(ThreadPool& pool, const Memory& memory) {
  size_t rows[kBatch];
  for (size_t& r : rows) r = random_.below(uint32_t(memory.size()));
  nn::forShares(pool, kShares, kBatch, [&](size_t s, size_t first, size_t count) {
    learnShare(memory, std::span(rows).subspan(first, count), s);
  });
  encoder_.step(kSettings, 1.0f / kBatch);
  head_.step(kSettings, 1.0f / kBatch);
  float loss = 0, apart = 0;
  for (const Share& s : shares_) {
    loss += s.loss;
    apart += s.apart;
  }
  apart_ += kFollow * (apart / kBatch - apart_);
  return loss / kBatch;
}

void InverseDynamics::encode(const float* places, size_t count, NetPass& pass,
                             std::vector<float>& points) const {
  const float* const encoded = pass.forward(encoder_.net(), places, count);
  points.assign(encoded, encoded + count * kLatent);
  for (size_t i = 0; i < count; ++i, places += kPlace) {
    const uint32_t code = uint32_t(places[kCode] * float(kCodes));
    for (size_t d = 0; d < kLatent; ++d) {
      if (code >> d & 1) points[i * kLatent + d] += kApart;
    }
  }
}

// Encodes both places of a decision as consecutive rows.
void InverseDynamics::learnShare(const Memory& memory, std::span<const size_t> rows, size_t s) {
  Share& share = shares_[s];
  const size_t count = rows.size();
  share.places.resize(2 * count * kPlace);
  share.moves.resize(count);
  for (size_t i = 0; i < count; ++i) {
    const auto [track, decision] = memory.at(rows[i]);
    std::copy_n(track->path->place(decision), 2 * kPlace, share.places.data() + 2 * i * kPlace);
    share.moves[i] = track->moves[decision];
  }
  // Two consecutive points form one row of 2 kLatent numbers.
  const float* const pairs = share.encoder.forward(encoder_.net(), share.places.data(), 2 * count);
  share.apart = 0;
  for (size_t i = 0; i < count; ++i) {
    const float* const pair = pairs + 2 * i * kLatent;
    share.apart += sqrtf32(latentDistance2(pair, pair + kLatent));
  }
  const float* const logits = share.head.forward(head_.net(), pairs, count);
  share.gradient.assign(count * kDynamicsOut, 0.0f);
  share.loss = 0;
  for (size_t i = 0; i < count; ++i) {
    float p[policy::kMoves];
    policy::probabilitiesOf(logits + i * kDynamicsOut, true, p);
    share.loss += nn::crossEntropy<policy::kMoves>(p, share.moves[i],
                                                   share.gradient.data() + i * kDynamicsOut);
  }
  share.pairGradient.resize(2 * count * kLatent);
  share.head.backward(head_.net(), pairs, count, share.gradient.data(), head_.gradient(s),
                      share.pairGradient.data());
  share.encoder.backward(encoder_.net(), share.places.data(), 2 * count, share.pairGradient.data(),
                         encoder_.gradient(s));
}

}  // namespace obby::baselines
