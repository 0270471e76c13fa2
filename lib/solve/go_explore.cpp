#include "solve/go_explore.h"

#include <algorithm>

#include "solve/binning.h"
#include "solve/rollout_group.h"

namespace obby::solve {

namespace {

// Rollouts a task of the pool: together they fill the lanes of the wide tick.
constexpr size_t kLeastRollouts = 16, kTaskRollouts = 256;
constexpr uint32_t kLookEvery = 3;           // ticks: a walking player needs seven for a cell
constexpr uint64_t kStepsPerRollout = 8000;  // of the search so far: when rounds double
constexpr float kClockReach = 10;            // studs around moving parts where the clock matters
constexpr uint64_t kSelectionStream = 1ull << 63;  // streams of rollouts count up from 0

ExploreContext makeContext(const Problem& problem, const Surfaces& surfaces,
                           const ExploreSettings& settings) {
  return {problem.level,   problem.query,
          surfaces.view(), jumpReach(problem.level.params),
          settings,        limitsJumps(problem.query)};
}

bool closer(const Closest& a, const Closest& b) {
  return a.waypoints > b.waypoints || (a.waypoints == b.waypoints && a.distance < b.distance);
}

}  // namespace

GoExplore::GoExplore(const Problem& problem, uint64_t seed, const GoExploreSettings& settings,
                     ThreadPool& pool)
    : problem_(problem),
      seed_(seed),
      settings_(settings),
      pool_(pool),
      surfaces_(problem.level),
      context_(makeContext(problem, surfaces_, settings.explore)),
      clock_(problem.level, kClockReach),
      binning_(makeBinning(problem, settings.cellWidth, clock_)),
      potential_(problem),
      phaseTicks_(
          std::max(settings.leastPhase, uint32_t(settings.phaseJumps * context_.reach.airTicks))),
      airTicks_(
          std::max(uint32_t(context_.reach.airTicks), problem.level.params.controlRate / 2u)),
      archive_(kMaxCells, problem.level.looseCount) {
  archive_.offer(cellKey(binning_, problem.start, problem.startLoose.data()), problem.start,
                 {0, kNone, 0}, potential_(problem.start), problem.startLoose.data());
  statistics_.closest.distance = potential_.distance(problem.start);
  statistics_.closest.position = problem.start.position;
}

void GoExplore::round() {
  chooseCells();
  const size_t share = (rollouts_.size() + size_t(pool_.size()) - 1) / size_t(pool_.size());
  const size_t some = std::clamp(share, kLeastRollouts, kTaskRollouts);
  const size_t tasks = (rollouts_.size() + some - 1) / some;
  pool_.run(int(tasks), [&](int task) {
    const size_t first = size_t(task) * some;
    explore(std::span(rollouts_).subspan(first, std::min(some, rollouts_.size() - first)));
  });
  merge();
  ++statistics_.rounds;
}

// Grows with the steps done, which are the same for any number of threads.
uint32_t GoExplore::roundSize() const {
  uint32_t size = settings_.rollouts;
  while (size < settings_.mostRollouts && statistics_.steps > size * kStepsPerRollout) size *= 2;
  return size;
}

void GoExplore::chooseCells() {
  rollouts_.resize(roundSize());
  selector_.update(archive_, pool_);
  Random random(seed_, kSelectionStream | statistics_.rounds);
  for (Rollout& r : rollouts_) {
    r.id = nextRollout_++;
    r.cell = selector_.pick(random);
    r.parent = archive_.node(r.cell);
  }
}

bool GoExplore::keeps(const sim::World& world) const {
  return !settings_.groundedOnly || grounded(world) || world.floorlessTicks >= airTicks_;
}

void GoExplore::explore(std::span<Rollout> rollouts) {
  RolloutGroup group(context_);
  std::vector<Keys> keys;
  std::vector<Look> looks;
  for (Rollout& r : rollouts) {
    r.candidates.clear();
    r.ticks = r.closestTicks = 0;
    r.closest = {};
    r.end = archive_.world(r.cell);
    const auto loose = archive_.loose(r.cell);
    r.endLoose.assign(loose.begin(), loose.end());
    const uint64_t key = cellKey(binning_, r.end, r.endLoose.data());
    keys.push_back({key, key});
    archive_.countSeen(r.cell);
    group.add(seed_, r.id, r.end, r.endLoose.data());
  }
  group.run(phaseTicks_, [&](uint32_t tick, std::span<const RolloutGroup::Member> members) {
    looks.clear();
    for (const RolloutGroup::Member& m : members) {
      rollouts[m.index].ticks = tick;
      if (tick % kLookEvery != 0 || m.world->outcome != sim::Outcome::running) continue;
      looks.push_back({cellKey(binning_, *m.world, m.loose), m.index, kNone});
    }
    look(rollouts, keys, looks);
  });
}

// The archive is far larger than the caches: what all rollouts ask of it is fetched before the
// first needs it.
void GoExplore::look(std::span<Rollout> rollouts, std::span<Keys> keys, std::span<Look> looks) {
  const auto isNew = [&](const Look& l) {
    return l.key != keys[l.rollout].kept && keeps(rollouts[l.rollout].end);
  };
  for (const Look& l : looks) {
    if (isNew(l)) archive_.prefetch(l.key);
  }
  for (Look& l : looks) {
    if (!isNew(l)) continue;
    l.cell = archive_.find(l.key);
    if (l.cell != kNone) archive_.prefetchCell(l.cell);
  }
  for (const Look& l : looks) {
    Rollout& r = rollouts[l.rollout];
    if (isNew(l)) {
      visit(r, l.key, l.cell);
      keys[l.rollout].kept = l.key;
    }
    if (l.key == keys[l.rollout].last) continue;
    keys[l.rollout].last = l.key;
    noteClosest(r);
  }
}

// Once for each cell that a rollout passes through. Counts, and passes on what the archive lacks.
void GoExplore::visit(Rollout& r, uint64_t key, uint32_t cell) {
  if (cell != kNone) {
    archive_.countSeen(cell);
    if (!archive_.better(cell, r.end)) return;
  }
  r.candidates.push_back({key, r.end, r.endLoose, potential_(r.end), r.ticks});
}

void GoExplore::noteClosest(Rollout& r) {
  const Closest here{r.end.waypoints, potential_.distance(r.end), {}, r.end.position};
  if (!closer(here, r.closest)) return;
  r.closest = here;
  r.closestTicks = r.ticks;
}

void GoExplore::merge() {
  goals_.clear();
  std::vector<std::pair<uint64_t, Node>> reached;  // rank and way
  for (const Rollout& r : rollouts_) {
    for (const Candidate& c : r.candidates) {
      archive_.offer(c.key, c.world, {r.id, r.parent, c.ticks}, c.potential, c.loose.data());
    }
    mergeEnd(r);
    if (r.end.outcome == sim::Outcome::goal) {
      reached.push_back({uint64_t(r.end.tick) << 16 | r.end.jumps, {r.id, r.parent, r.ticks}});
    }
  }
  std::stable_sort(reached.begin(), reached.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [rank, way] : reached) goals_.push_back(way);
}

void GoExplore::mergeEnd(const Rollout& r) {
  statistics_.steps += r.ticks;
  statistics_.overruns |= uint8_t(r.end.flags & sim::kOverruns);
  const Node way{r.id, r.parent, r.ticks};
  if (r.end.outcome != sim::Outcome::goal) {
    attempts_.add({way, r.end.position, r.end.outcome, r.end.part});
  }
  if (!closer(r.closest, statistics_.closest)) return;
  statistics_.closest = r.closest;
  statistics_.closest.way = {r.id, r.parent, r.closestTicks};
}

}  // namespace obby::solve
