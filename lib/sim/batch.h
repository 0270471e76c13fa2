// Many worlds, of one level or of many, stepped together. What a world becomes depends on its own
// state, episode and actions only: the machine, the number of threads, the order of worlds and how
// ticks are cut into steps never show.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "base/thread_pool.h"
#include "level/level.h"
#include "sim/actions.h"
#include "sim/device.h"
#include "sim/episodes.h"
#include "sim/loose.h"

namespace obby::sim {

// What worlds play, with tables of its own.
struct Course {
  std::vector<level::LevelView> levels;   // at least one; what they point to must outlive the batch
  std::vector<level::QueryView> queries;  // one a level, or none: no rules
  std::vector<World> starts;              // one a level
  std::vector<uint32_t> queue;            // of levels, as handed out; empty: in their order
  bool restarts = false;  // a world whose playthrough has ended takes its next level

  // Loose bodies at the starts, filled in by makeBatch: (levels, looseStride).
  std::vector<LooseBody> startLoose;
  uint32_t looseStride = 0;  // most loose bodies of any level

  LevelSet set() const;  // valid while this object lives and stays as it is
};

// A course of one level, every world at `start`.
Course courseOf(const level::LevelView& level, const level::StartPose& start);

// Where a step's actions come from; the spans must live as long as the step.
struct Actions {
  ActionKind kind = ActionKind::walker;
  uint64_t seed = 0;
  std::span<const Action> table;
  std::span<const ActionRun> runs;
  std::span<const uint32_t> firsts;

  static Actions walker(uint64_t seed) { return {ActionKind::walker, seed, {}, {}, {}}; }
  // Row by row, a row a tick: (ticks, worlds).
  static Actions tabulated(std::span<const Action> table) {
    return {ActionKind::table, 0, table, {}, {}};
  }
  // World i holds runs[firsts[i]] ... runs[firsts[i + 1] - 1], counted from the step's first tick,
  // then stands still.
  static Actions plans(std::span<const ActionRun> runs, std::span<const uint32_t> firsts) {
    return {ActionKind::plans, 0, {}, runs, firsts};
  }
};

class Batch {
 public:
  virtual ~Batch() = default;

  uint32_t size() const { return size_; }

  // Advances every world by `ticks`; one whose playthrough has ended waits, or starts its next
  // level if the course restarts. An error says what is wrong with the actions, or is the device's.
  Status step(uint32_t ticks, const Actions& actions);

  // Worlds `first` and on, and what they play. Snapshots are plain copies of the worlds and of
  // their loose bodies: (worlds, looseStride), none where no level has any.
  virtual Status restore(uint32_t first, std::span<const World> worlds,
                         std::span<const LooseBody> loose = {}) = 0;
  virtual Result<std::vector<World>> worlds() const = 0;
  virtual Result<std::vector<LooseBody>> loose() const = 0;
  virtual Result<std::vector<Episode>> episodes() const = 0;

  // Digest of all states in order.
  Result<uint64_t> hash() const;

 protected:
  explicit Batch(uint32_t size, uint32_t looseStride) : size_(size), looseStride_(looseStride) {}
  virtual Status run(uint32_t ticks, const Actions& actions) = 0;

 private:
  const uint32_t size_, looseStride_;
};

// On the CPU's lanes, a task of the pool for every few hundred worlds of one level. The pool must
// outlive the batch.
Result<std::unique_ptr<Batch>> makeCpuBatch(Course course, uint32_t worlds, ThreadPool& pool);

// By the step kernel. The device must outlive the batch, which keeps its own copy of the course.
Result<std::unique_ptr<Batch>> makeKernelBatch(const Course& course, uint32_t worlds,
                                               Device& device);

// The kernels of makeKernelBatch.
const Kernel& stepKernel(StepKind kind);

}  // namespace obby::sim
