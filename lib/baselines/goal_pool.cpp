#include "baselines/goal_pool.h"

#include <algorithm>
#include <numeric>

namespace obby::baselines {

// Leaves out falling states. They are the sparsest, but a player cannot stay there to explore.
void GoalPool::add(const std::shared_ptr<const Path>& path) {
  for (uint32_t i = 1; i < path->size(); ++i) {
    if (path->stands[i]) fresh_.push_back({path, i});
  }
}

void GoalPool::refresh(ThreadPool& pool, const InverseDynamics& module, NetPass& pass) {
  std::vector<Goal> all(ranked_.begin(),
                        ranked_.begin() + ptrdiff_t(std::min(kHalf, ranked_.size())));
  const size_t taken = std::min(kHalf, fresh_.size());
  for (size_t i = 0; i < taken; ++i) all.push_back(fresh_[i * fresh_.size() / taken]);
  fresh_.clear();
  const uint32_t k = neighbourFor(uint32_t(all.size()));
  if (all.size() <= k) return;
  std::vector<float> places;
  for (const Goal& g : all) {
    const float* const place = g.path->place(g.index);
    places.insert(places.end(), place, place + kPlace);
  }
  std::vector<float> points;
  module.encode(places.data(), all.size(), pass, points);
  const std::vector<float> apart = neighbourDistances2(pool, points, k);
  std::vector<uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return apart[a] > apart[b]; });
  ranked_.clear();
  for (const uint32_t i : order) ranked_.push_back(std::move(all[i]));
}

}  // namespace obby::baselines
