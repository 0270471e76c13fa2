// Go-Explore in rounds: a chooser picks cells, all threads roll out from each against a snapshot of
// the archive, and what was found is merged in the order of the rollouts. Everything follows from
// (problem, seed, settings, chooser): threads and time only decide when it stops.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solve/archive.h"
#include "solve/attempts.h"
#include "solve/cell.h"
#include "solve/chooser.h"
#include "solve/device_rollouts.h"
#include "solve/explore_context.h"
#include "solve/machine.h"
#include "solve/playthrough.h"
#include "solve/potential.h"
#include "solve/problem.h"
#include "solve/selection.h"
#include "solve/surfaces.h"
#include "solve/trail.h"

namespace obby::solve {

// The defaults were measured over levels/ (ticks to the first solution).
struct GoExploreSettings {
  uint32_t rollouts = 32;       // a round, at first: short generations answer easy queries soon
  uint32_t mostRollouts = 512;  // a round, once the search is long: keeps all threads busy
  float phaseJumps = 4;         // length of a rollout, in flat jumps' air time
  uint32_t leastPhase = 40;     // ticks
  float cellWidth = 2;          // studs at 16 studs/s; grows with walking speed
  bool groundedOnly = true;     // keep states that stand, or have been in the air for long
  uint32_t lookEvery = 3;  // ticks between states that may be kept; walking, a cell takes seven
  ExploreSettings explore;
};

// How far the search has come, and the way there.
struct Closest : Approach {
  Node way{0, kNone, 0};
};

struct Statistics {
  uint64_t steps = 0;  // simulated ticks
  uint64_t rounds = 0;
  uint64_t rollouts = 0;
  uint64_t idleRollouts = 0;  // since the last that found a new cell
  uint8_t overruns = 0;       // sim::Flag bits of any attempt
  Closest closest;
};

class GoExplore {
 public:
  // `machine` is used by round() only. A device that fails is not asked again: the pool goes on,
  // with the same results.
  GoExplore(const Problem& problem, uint64_t seed, const GoExploreSettings& settings,
            const Machine& machine, MakeChooser makeChooser = hedgedSelector);

  // Tries `count` ways of Problem::known from `first` on; to be called before round(), and like it.
  void tryKnown(size_t first, size_t count);

  // One round. Ways that reached the goal are appended to goals().
  void round();

  const Statistics& statistics() const { return statistics_; }
  const Archive& archive() const { return archive_; }
  const Attempts& attempts() const { return attempts_; }
  const ExploreContext& context() const { return context_; }
  const Status& deviceStatus() const { return deviceStatus_; }

  // Ways to the goal of the last round, fewest ticks, then jumps, first.
  const std::vector<Node>& goals() const { return goals_; }

  Playthrough playthrough(const Node& end) const {
    return regenerate(context_, seed_, problem_, archive_.nodes(), end);
  }

 private:
  struct Candidate {  // a state that is new or better than what the archive held
    uint64_t key;
    sim::World world;
    std::vector<sim::LooseBody> loose;
    float potential;
    uint32_t ticks;
  };
  struct Rollout {
    uint64_t id = 0;
    Choice start{};
    uint32_t parent = 0;  // node of the start
    uint32_t ticks = 0;
    uint32_t closestTicks = 0;
    Approach closest;
    sim::World end;
    std::vector<sim::LooseBody> endLoose;
    std::vector<Candidate> candidates;
  };

  uint32_t roundSize() const;
  void chooseCells();
  struct Look {  // at where a rollout is after a tick
    uint64_t key;
    size_t rollout;
  };

  void follow(Rollout& rollout, const KnownWay& way);
  void exploreOnThreads();
  Status openDevice();
  Status exploreOnDevice();
  void explore(std::span<Rollout> rollouts);
  void look(std::span<Rollout> rollouts, std::span<Trail> trails, std::span<Look> looks);
  void visit(Rollout& rollout, uint64_t key, uint32_t cell, const sim::World& world,
             std::span<const sim::LooseBody> loose, uint32_t ticks);
  void noteClosest(Rollout& rollout);
  void merge();
  Tried keep(const Rollout& rollout);
  void mergeEnd(const Rollout& rollout);

  const Problem problem_;
  const uint64_t seed_;
  const GoExploreSettings settings_;
  Machine machine_;
  std::optional<DeviceRollouts> device_;
  Status deviceStatus_;
  Surfaces surfaces_;
  ExploreContext context_;
  ClockMap clock_;
  Binning binning_;
  Potential potential_;
  uint32_t phaseTicks_;
  KeepRule rule_;
  Archive archive_;
  std::unique_ptr<Chooser> chooser_;
  Attempts attempts_;
  std::vector<Choice> choices_;    // of this round
  std::vector<Rollout> rollouts_;  // (choices)
  std::vector<Tried> tried_;       // (choices)
  uint64_t nextRollout_ = 0;
  std::vector<Node> goals_;
  Statistics statistics_;
};

}  // namespace obby::solve
