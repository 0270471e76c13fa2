#include "sim/batch.h"

#include <algorithm>

#include "base/hash.h"
#include "sim/simulator.h"

namespace obby::sim {
namespace {
constexpr size_t kBlock = 256;  // worlds a task: what the wide tick takes at once
}

Batch::Batch(const level::LevelView& level, const level::StartPose& start, size_t worlds)
    : level_(level), worlds_(worlds, makeWorld(level, start)) {
  const std::vector<LooseBody> loose = makeLoose(level);
  for (size_t i = 0; i < worlds && !loose.empty(); ++i) {
    loose_.insert(loose_.end(), loose.begin(), loose.end());
  }
}

void Batch::step(ThreadPool& pool, const level::QueryView* query, uint32_t ticks,
                 const Controller& controller) {
  const size_t blocks = (worlds_.size() + kBlock - 1) / kBlock;
  pool.run(int(blocks), [&](int block) {
    std::vector<size_t> running;
    std::vector<World*> worlds;
    std::vector<LooseBody*> loose;
    std::vector<Action> actions;
    const size_t last = std::min(worlds_.size(), (size_t(block) + 1) * kBlock);
    for (size_t i = size_t(block) * kBlock; i < last; ++i) {
      running.push_back(i);
    }
    for (uint32_t t = 0; t < ticks && !running.empty(); ++t) {
      worlds.clear();
      loose.clear();
      actions.clear();
      std::erase_if(running, [&](size_t i) { return worlds_[i].outcome != Outcome::running; });
      for (const size_t i : running) {
        worlds.push_back(&worlds_[i]);
        loose.push_back(loose_.data() + i * level_.looseCount);
        actions.push_back(controller(i, worlds_[i]));
      }
      advanceAll(level_, query, worlds, loose.data(), actions.data());
    }
  });
}

uint64_t Batch::hash() const {
  uint64_t h = 0;
  for (size_t i = 0; i < worlds_.size(); ++i) {
    const uint64_t state = stateHash(worlds_[i], loose(i));
    h = hashBytes(&state, sizeof state, h);
  }
  return h;
}

}  // namespace obby::sim
