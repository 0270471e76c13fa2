// The module behind CFLGE's latent space. It trains an encoder of places together with a network
// that predicts the move between two successive places. So the space ignores what moves cannot
// change. Host only.
#pragma once

#include <span>

#include "baselines/latent.h"
#include "baselines/names.h"
#include "baselines/net_pass.h"
#include "baselines/track.h"
#include "nn/learner.h"

namespace obby::baselines {

class InverseDynamics {
 public:
  static constexpr size_t kBatch = 32;  // decisions per step

  // `device`: as for NetPass.
  explicit InverseDynamics(uint64_t seed, DeviceWork* device = nullptr);

  // Takes one step on decisions sampled from the memory. Returns their mean loss; an untrained
  // network has log(moves).
  float learn(ThreadPool& pool, const Memory& memory);

  // Returns the distance within which a goal counts as reached: the mean movement in the latent
  // space in four decisions.
  float reach() const { return 4 * apart_; }

  // Fills `points`, (count, kLatent), from `count` places, (count, kPlace). No single move
  // determines the waypoints and visits so far, so each set of them shifts the points by its own
  // offset. Safe to call from several threads, each with its own pass.
  void encode(const float* places, size_t count, NetPass& pass, std::vector<float>& points) const;

 private:
  struct Share {
    NetPass encoder, head;
    std::vector<float> places, gradient, pairGradient;
    std::vector<uint8_t> moves;
    float loss = 0, apart = 0;
  };
  void learnShare(const Memory& memory, std::span<const size_t> rows, size_t s);

  Random random_;
  nn::Learner encoder_, head_;
  Share shares_[kShares];
  float apart_ = 0.25f;  // running mean of the latent distance that a decision covers
};

}  // namespace obby::baselines
