#include "solve/selection.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr float kWeightScale = 1048576.0f;  // weight of the best potential, never seen
constexpr uint32_t kBlock = 512;            // cells a block of running sums
constexpr uint32_t kTaskBlocks = 16;        // blocks a task of the pool

uint64_t below(Random& random, uint64_t n) {
  const uint64_t high = random.next(), low = random.next();
  return uint64_t((__extension__ static_cast<unsigned __int128>(high << 32 | low) * n) >> 64);
}

}  // namespace

uint32_t selectionWeight(float potential, float best, uint32_t seen, float hedge) {
  const float lean = std::max(potential / best, hedge);
  return 1u + uint32_t(kWeightScale * lean / sqrtf32(float(seen) + 1.0f));
}

void Selector::update(const Archive& archive, ThreadPool& pool) {
  const uint32_t cells = archive.cellCount();
  const uint32_t blocks = (cells + kBlock - 1) / kBlock;
  weights_.resize(cells);
  sums_.resize(blocks);
  const float best = archive.bestPotential();
  const float* potentials = archive.potentials().data();
  const uint32_t* seen = archive.seen().data();
  pool.run(int((blocks + kTaskBlocks - 1) / kTaskBlocks), [&](int task) {
    const uint32_t last = std::min((uint32_t(task) + 1) * kTaskBlocks, blocks);
    for (uint32_t block = uint32_t(task) * kTaskBlocks; block < last; ++block) {
      uint64_t sum = 0;
      const uint32_t end = std::min((block + 1) * kBlock, cells);
      for (uint32_t i = block * kBlock; i < end; ++i) {
        sum += weights_[i] = selectionWeight(potentials[i], best, seen[i], hedge_);
      }
      sums_[block] = sum;
    }
  });
  for (uint32_t block = 1; block < blocks; ++block) sums_[block] += sums_[block - 1];
}

uint32_t Selector::pick(Random& random) const {
  uint64_t rest = below(random, sums_.back());
  const size_t block = size_t(std::upper_bound(sums_.begin(), sums_.end(), rest) - sums_.begin());
  if (block > 0) rest -= sums_[block - 1];
  uint32_t cell = uint32_t(block) * kBlock;
  while (rest >= weights_[cell]) rest -= weights_[cell++];
  return cell;
}

void Selector::choose(const Archive& archive, ThreadPool& pool, Random& random,
                      std::span<Choice> choices) {
  update(archive, pool);
  for (Choice& c : choices) c.cell = pick(random);
}

std::unique_ptr<Chooser> hedgedSelector(const Problem&, const ExploreContext&) {
  return std::make_unique<Selector>(0.1f);
}

std::unique_ptr<Chooser> plainSelector(const Problem&, const ExploreContext&) {
  return std::make_unique<Selector>(0.0f);
}

}  // namespace obby::solve
