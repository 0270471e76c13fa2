// Many worlds, of one level or of many, stepped together. The result of a world depends only on its
// own state, episode and actions. The machine, the number of threads, the order of worlds and the
// division of ticks into steps have no effect.
//
//   OBBY_ASSIGN(const auto batch,
//               sim::makeCpuBatch(sim::courseOf(level.view(), level.spawns()[0]), 1024, pool));
//   OBBY_RETURN_IF_ERROR(batch->step(60, sim::Actions::walker(seed)));
//   OBBY_ASSIGN(const std::vector<sim::World> worlds, batch->worlds());
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "base/thread_pool.h"
#include "level/level.h"
#include "sim/actions.h"
#include "sim/device.h"
#include "sim/episodes.h"
#include "sim/rigid_body.h"

namespace obby::sim {

// The levels, queries and starts that the worlds of a batch play.
struct Course {
  std::vector<level::LevelView> levels;   // at least one; their tables must outlive the batch
  std::vector<level::QueryView> queries;  // one per level, or empty for no rules
  std::vector<World> starts;              // one per level
  std::vector<uint32_t> queue;            // level indices in the order of play; empty to play each
                                          // once in order
  bool restarts = false;                  // a world whose trajectory has ended takes its next level

  // Dynamic bodies at the starts, filled in when a batch is made: (levels, bodyStride).
  std::vector<RigidBody> startBodies;
  uint32_t bodyStride = 0;  // max bodies of any level

  LevelSet set() const;  // valid while this object lives unchanged
};

// Returns a course of one level, with every world at `start`.
Course courseOf(const level::LevelView& level, const level::StartPose& start);

// The source of a step's actions. The spans must outlive the step.
struct Actions {
  ActionKind kind = ActionKind::walker;
  uint64_t seed = 0;
  std::span<const Action> table;
  std::span<const ActionRun> runs;
  std::span<const uint32_t> firsts;

  static Actions walker(uint64_t seed) { return {ActionKind::walker, seed, {}, {}, {}}; }
  // Returns actions from a table with one row per tick: (ticks, worlds).
  static Actions tabulated(std::span<const Action> table) {
    return {ActionKind::table, 0, table, {}, {}};
  }
  // World i plays runs[firsts[i]] ... runs[firsts[i + 1] - 1] from the step's first tick on, then
  // stands still.
  static Actions plans(std::span<const ActionRun> runs, std::span<const uint32_t> firsts) {
    return {ActionKind::plans, 0, {}, runs, firsts};
  }
};

class Batch {
 public:
  virtual ~Batch() = default;

  uint32_t size() const { return size_; }

  // Advances every world by `ticks`. A world whose trajectory has ended waits, or starts its next
  // level if the course restarts. Invalid actions and errors of the device are errors.
  Status step(uint32_t ticks, const Actions& actions);

  // restore() replaces the worlds from `first` on, which must be worlds of the batch. Snapshots are
  // plain copies of the worlds and of their dynamic bodies: (worlds, bodyStride), or empty if no
  // level has bodies. Errors are those of the device.
  virtual Status restore(uint32_t first, std::span<const World> worlds,
                         std::span<const RigidBody> bodies = {}) = 0;
  virtual Result<std::vector<World>> worlds() const = 0;
  virtual Result<std::vector<RigidBody>> bodies() const = 0;
  virtual Result<std::vector<Episode>> episodes() const = 0;

  // Returns a digest of all states in order.
  Result<uint64_t> hash() const;

 protected:
  explicit Batch(uint32_t size, uint32_t bodyStride) : size_(size), bodyStride_(bodyStride) {}
  virtual Status run(uint32_t ticks, const Actions& actions) = 0;

 private:
  const uint32_t size_, bodyStride_;
};

// Makes a batch on the CPU's lanes, with one task of the pool for every few hundred worlds of one
// level. The pool must outlive the batch.
Result<std::unique_ptr<Batch>> makeCpuBatch(Course course, uint32_t worlds, ThreadPool& pool);

// Makes a batch that runs the step kernel. The device must outlive the batch, which keeps its own
// copy of the course.
Result<std::unique_ptr<Batch>> makeKernelBatch(const Course& course, uint32_t worlds,
                                               Device& device);

// Returns the kernels of makeKernelBatch.
const Kernel& stepKernel(StepKind kind);

}  // namespace obby::sim
