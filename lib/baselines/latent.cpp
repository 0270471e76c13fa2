#include "baselines/latent.h"

#include <algorithm>

#include "math/exponential.h"
#include "math/lanes.h"

namespace obby::baselines {

namespace {

constexpr size_t kTaskPoints = 64;  // points per task of the pool

// Returns the k-th smallest of `values`, without the one at `self`.
float kthLeast(const std::vector<float>& values, uint32_t k, size_t self) {
  std::vector<float> least(k, 1e30f);  // ascending
  for (size_t j = 0; j < values.size(); ++j) {
    if (!(values[j] < least.back()) || j == self) continue;
    least.back() = values[j];
    for (size_t i = k - 1; i > 0 && least[i] < least[i - 1]; --i) std::swap(least[i], least[i - 1]);
  }
  return least.back();
}

}  // namespace

float latentDistance2(const float* a, const float* b) {
  float sum = 0;
  for (size_t d = 0; d < kLatent; ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}

std::vector<uint32_t> thinned(const float* points, size_t count, float apart) {
  std::vector<uint32_t> kept;
  for (size_t i = count; i-- > 0;) {
    if (!kept.empty() &&
        latentDistance2(points + i * kLatent, points + kept.back() * kLatent) < apart * apart)
      continue;
    kept.push_back(uint32_t(i));
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

uint32_t drawGeometric(Random& random, float p, uint32_t count) {
  const float fall = logOf(1 - p);  // log ratio of the probabilities of successive ranks
  const float all = 1 - expNegative(fall * float(count));
  const float rank = logOf(1 - random.unit() * all) / fall;
  return std::min(uint32_t(std::max(rank, 0.0f)), count - 1);
}

uint32_t neighbourFor(uint32_t count) {
  static_assert(kLatent == 16, "four square roots");
  const float root = sqrtf32(sqrtf32(sqrtf32(sqrtf32(float(count)))));
  return uint32_t(2 * root);
}

std::vector<float> neighbourDistances2(ThreadPool& pool, const std::vector<float>& points,
                                       uint32_t k) {
  const size_t count = points.size() / kLatent;
  std::vector<float> turned(points.size()), result(count);  // turned: (kLatent, count)
  for (size_t i = 0; i < count; ++i) {
    for (size_t d = 0; d < kLatent; ++d) turned[d * count + i] = points[i * kLatent + d];
  }
  pool.run(int((count + kTaskPoints - 1) / kTaskPoints), [&](int task) {
    std::vector<float> distances(count);
    const size_t first = size_t(task) * kTaskPoints;
    for (size_t i = first; i < std::min(first + kTaskPoints, count); ++i) {
      std::fill(distances.begin(), distances.end(), 0.0f);
      for (size_t d = 0; d < kLatent; ++d) {
        const float here = points[i * kLatent + d];
        const float* const there = turned.data() + d * count;
        for (size_t j = 0; j < count; ++j) {
          const float apart = here - there[j];
          distances[j] += apart * apart;
        }
      }
      result[i] = kthLeast(distances, k, i);
    }
  });
  return result;
}

}  // namespace obby::baselines
