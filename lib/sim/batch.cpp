#include "sim/batch.h"

#include <algorithm>

#include "base/hash.h"
#include "sim/simulator.h"

namespace obby::sim {
namespace {
constexpr size_t kBlock =
    64;  // worlds a task: long enough to hide the hand-over, short enough to balance
}

Batch::Batch(const level::LevelView& level, const level::StartPose& start, size_t worlds)
    : level_(level), worlds_(worlds, makeWorld(level, start)) {}

void Batch::step(ThreadPool& pool, const level::QueryView* query, uint32_t ticks,
                 const Controller& controller) {
  const size_t blocks = (worlds_.size() + kBlock - 1) / kBlock;
  pool.run(int(blocks), [&](int block) {
    const size_t last = std::min(worlds_.size(), (size_t(block) + 1) * kBlock);
    for (size_t i = size_t(block) * kBlock; i < last; ++i) {
      World& w = worlds_[i];
      for (uint32_t t = 0; t < ticks && w.outcome == Outcome::running; ++t) {
        advance(w, level_, query, controller(i, w));
      }
    }
  });
}

uint64_t Batch::hash() const {
  uint64_t h = 0;
  for (const World& w : worlds_) {
    const uint64_t state = stateHash(w);
    h = hashBytes(&state, sizeof state, h);
  }
  return h;
}

}  // namespace obby::sim
