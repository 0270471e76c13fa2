// A batch on the CPU's lanes. Worlds of one level share a block, so that the lanes are full and the
// level stays in the cache. A world that changes its level waits until the worlds are sorted again.
// It then takes the ticks that it has missed with its new neighbours.
#include <algorithm>

#include "sim/first_worlds.h"
#include "sim/simulator.h"

namespace obby::sim {
namespace {

constexpr uint32_t kBlock = 256;  // worlds per task, as many as the wide tick takes at once
// Ticks until worlds that changed their level are sorted again. With more ticks, more worlds are
// left over at the end of a step, where they do not fill the lanes. With fewer ticks, the thread
// pool runs more often.
constexpr uint32_t kPassTicks = 32;

class CpuBatch : public Batch {
 public:
  CpuBatch(Course course, FirstWorlds first, ThreadPool& pool)
      : Batch(uint32_t(first.worlds.size()), course.bodyStride),
        course_(std::move(course)),
        worlds_(std::move(first.worlds)),
        bodies_(std::move(first.bodies)),
        episodes_(std::move(first.episodes)),
        pool_(pool) {}

  Status restore(uint32_t first, std::span<const World> worlds,
                 std::span<const RigidBody> bodies) override {
    std::copy(worlds.begin(), worlds.end(), worlds_.begin() + first);
    std::copy(bodies.begin(), bodies.end(), bodies_.begin() + first * course_.bodyStride);
    return {};
  }
  Result<std::vector<RigidBody>> bodies() const override { return bodies_; }
  Result<std::vector<World>> worlds() const override { return worlds_; }
  Result<std::vector<Episode>> episodes() const override { return episodes_; }

 private:
  struct Turn {  // the progress of a world in this step
    ActionCursor cursor;
    uint32_t left;  // ticks
  };
  struct Block {  // a range of order_
    uint32_t first, count;
  };

  Status run(uint32_t ticks, const Actions& actions) override;
  void admit();
  void cut();
  void play(const Block& block, uint32_t ticks);
  bool readyIn(uint32_t level, uint32_t world);
  void startOver(uint32_t world);
  RigidBody* bodiesOf(uint32_t world) {
    return bodies_.data() + size_t(world) * course_.bodyStride;
  }
  bool waits(uint32_t world) const {
    return turns_[world].left > 0 &&
           (course_.restarts || worlds_[world].outcome == Outcome::running);
  }

  const Course course_;
  const LevelSet set_ = course_.set();
  std::vector<World> worlds_;
  std::vector<RigidBody> bodies_;  // (worlds, bodyStride)
  std::vector<Episode> episodes_;
  ThreadPool& pool_;

  // State of the current step.
  ActionView actions_;
  uint32_t ticks_ = 0;
  std::vector<Turn> turns_;
  std::vector<uint32_t> order_;  // worlds with ticks left, by level
  std::vector<Block> blocks_;
};

Status CpuBatch::run(uint32_t ticks, const Actions& actions) {
  actions_ = {actions.kind, actions.seed, actions.table.data(), actions.runs.data(),
              actions.firsts.data()};
  ticks_ = ticks;
  turns_.assign(size(), {{}, ticks});
  const bool changes = course_.restarts && course_.levels.size() > 1;
  const uint32_t pass = changes ? std::min(ticks, kPassTicks) : ticks;
  for (admit(); !order_.empty(); admit()) {
    cut();
    pool_.run(int(blocks_.size()), [&](int b) { play(blocks_[size_t(b)], pass); });
  }
  return {};
}

void CpuBatch::startOver(uint32_t world) {
  startNext(set_, world, size(), episodes_[world], worlds_[world], bodiesOf(world));
  turns_[world].cursor.startOver(actions_);
}

// Sorts the worlds with ticks left by their levels.
void CpuBatch::admit() {
  std::vector<uint32_t> starts(course_.levels.size() + 1, 0);
  for (uint32_t i = 0; i < size(); ++i) {
    if (!waits(i)) continue;
    if (worlds_[i].outcome != Outcome::running) startOver(i);
    ++starts[episodes_[i].level + 1];
  }
  for (size_t n = 1; n < starts.size(); ++n) starts[n] += starts[n - 1];
  order_.resize(starts.back());
  for (uint32_t i = 0; i < size(); ++i) {
    if (waits(i)) order_[starts[episodes_[i].level]++] = i;
  }
}

void CpuBatch::cut() {
  blocks_.clear();
  for (uint32_t i = 0; i < order_.size(); ++i) {
    const bool goesOn = i > 0 && blocks_.back().count < kBlock &&
                        episodes_[order_[i]].level == episodes_[order_[i - 1]].level;
    if (goesOn) {
      ++blocks_.back().count;
    } else {
      blocks_.push_back({i, 1});
    }
  }
}

// Returns true if the world can take a tick in this level. Starts its next trajectory if that is in
// this level, too.
bool CpuBatch::readyIn(uint32_t level, uint32_t world) {
  if (!waits(world)) return false;
  if (worlds_[world].outcome == Outcome::running) return true;
  if (levelOf(set_, world, size(), episodes_[world].number + 1) != level) return false;
  startOver(world);
  return true;
}

void CpuBatch::play(const Block& block, uint32_t ticks) {
  std::vector<uint32_t> running(order_.begin() + block.first,
                                order_.begin() + block.first + block.count);
  const uint32_t level = episodes_[running.front()].level;
  std::vector<World*> worlds;
  std::vector<RigidBody*> bodies;
  std::vector<Action> actions;
  for (uint32_t t = 0; t < ticks; ++t) {
    worlds.clear();
    bodies.clear();
    actions.clear();
    std::erase_if(running, [&](uint32_t i) { return !readyIn(level, i); });
    if (running.empty()) return;
    for (const uint32_t i : running) {
      Turn& turn = turns_[i];
      const Asking who{i, size(), episodes_[i].number, ticks_ - turn.left--};
      worlds.push_back(&worlds_[i]);
      bodies.push_back(bodiesOf(i));
      actions.push_back(turn.cursor.next(actions_, who, worlds_[i].tick));
    }
    advanceAll(course_.levels[level], queryOf(set_, level), worlds, bodies.data(), actions.data());
  }
}

}  // namespace

Result<std::unique_ptr<Batch>> makeCpuBatch(Course course, uint32_t worlds, ThreadPool& pool) {
  OBBY_ASSIGN(FirstWorlds first, firstWorlds(course, worlds));
  return std::unique_ptr<Batch>(
      std::make_unique<CpuBatch>(std::move(course), std::move(first), pool));
}

}  // namespace obby::sim
