// The module that makes CFLGE's latent space: an encoder of places, trained together with a network
// that tells from two successive places which move was made between them. What moves cannot change
// has no part in it. Host only.
#pragma once

#include <span>

#include "nn/learner.h"
#include "solve/learned/latent.h"
#include "solve/learned/net_pass.h"
#include "solve/learned/track.h"

namespace obby::solve::learned {

class InverseDynamics {
 public:
  static constexpr size_t kBatch = 32;  // decisions a step

  // `device`: as NetPass.
  explicit InverseDynamics(uint64_t seed, DeviceWork* device = nullptr);

  // One step on decisions drawn from the memory. Gives their mean loss, log(moves) when nothing is
  // known.
  float learn(ThreadPool& pool, const Memory& memory);

  // Who is nearer to a goal than this has reached it: what players move in the latent space in
  // four decisions, on average.
  float reach() const { return 4 * apart_; }

  // Fills `points`, (count, kLatent), with those of `count` places, (count, kPlace). No move alone
  // tells the waypoints and visits behind, so each set of these shifts points by a step of its own.
  // Safe to call from several threads, each with a pass of its own.
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
  float apart_ = 0.25f;  // how far apart the points around a decision are, lately
};

}  // namespace obby::solve::learned
