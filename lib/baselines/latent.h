// Points in the latent space: distances, the choice of sub-goals on a trajectory, and a draw by
// rank. Host only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "base/thread_pool.h"
#include "baselines/names.h"

namespace obby::baselines {

constexpr size_t kLatent = 16;  // numbers

// Returns the squared distance between two points, (kLatent) each.
float latentDistance2(const float* a, const float* b);

// Returns the indices of sub-goals among the `count` points of a trajectory, (count, kLatent), in
// ascending order. Going back from the last point, it keeps each point that is at least `apart`
// from the one kept before.
std::vector<uint32_t> thinned(const float* points, size_t count, float apart);

// Draws from 0 to `count` - 1 with probabilities that fall by a factor of 1 - p each; count > 0.
uint32_t drawGeometric(Random& random, float p, uint32_t count);

// Returns the rank of the neighbour whose distance estimates the density of `count` points: 2
// count^(1 / kLatent).
uint32_t neighbourFor(uint32_t count);

// Returns the squared distance from each point to its k-th nearest neighbour; smaller means denser.
// `points`: (count, kLatent), count > k > 0.
std::vector<float> neighbourDistances2(ThreadPool& pool, const std::vector<float>& points,
                                       uint32_t k);

}  // namespace obby::baselines
