#include "solve/search/methods/go_explore.h"

#include <algorithm>

namespace obby::solve {

namespace {

// Rollouts per task of the pool. Together they fill the lanes of the wide tick.
constexpr size_t kMinTaskRollouts = 16, kTaskRollouts = 256;
constexpr uint64_t kStepsPerRollout =
    8000;  // steps so far per rollout of a round; then rounds double

}  // namespace

GoExplore::GoExplore(const Problem& problem, uint64_t seed, const GoExploreSettings& settings,
                     const Machine& machine, MakeSelector makeSelector)
    : ArchiveSearch(problem, seed, settings),
      settings_(settings),
      machine_(machine),
      selector_(makeSelector(problem, context())),
      companions_(problem_, context(), seed) {}

void GoExplore::round() {
  chooseCells();
  if (machine_.device != nullptr) {
    deviceStatus_ = exploreOnDevice();
    if (!deviceStatus_) machine_.device = nullptr;
  }
  if (machine_.device == nullptr) exploreOnThreads();
  merge();
  ++statistics_.rounds;
}

void GoExplore::exploreOnThreads() {
  const size_t threads = size_t(machine_.pool.size());
  const size_t share = (rollouts_.size() + threads - 1) / threads;
  const size_t some = std::clamp(share, kMinTaskRollouts, kTaskRollouts);
  const size_t tasks = (rollouts_.size() + some - 1) / some;
  machine_.pool.run(int(tasks), [&](int task) {
    const size_t first = size_t(task) * some;
    explore(std::span(rollouts_).subspan(first, std::min(some, rollouts_.size() - first)));
  });
}

Status GoExplore::openDevice() {
  if (device_) return {};
  OBBY_ASSIGN(device_, DeviceRollouts::open(*machine_.device, setup_.rules));
  return {};
}

// Nothing is noted before the device is done: a round that fails is repeated on the threads.
Status GoExplore::exploreOnDevice() {
  OBBY_RETURN_IF_ERROR(openDevice());
  std::vector<RolloutStart> starts;
  std::vector<sim::RigidBody> bodies;
  for (const Rollout& r : rollouts_) {
    starts.push_back({archive_.world(r.start.cell), r.id, r.start.ticks});
    const auto some = archive_.bodies(r.start.cell);
    bodies.insert(bodies.end(), some.begin(), some.end());
  }
  OBBY_RETURN_IF_ERROR(device_->run(starts, bodies));
  for (size_t i = 0; i < rollouts_.size(); ++i) {
    Rollout& r = rollouts_[i];
    const RolloutEnd& end = device_->ends()[i];
    r.candidates.clear();
    r.ticks = end.ticks;
    r.closest = end.closest;
    r.closestTicks = end.closestTicks;
    r.end = end.world;
    const auto left = device_->endBodies(i);
    r.endBodies.assign(left.begin(), left.end());
    archive_.countSeen(r.start.cell);
    const std::span<const RolloutVisit> visits = device_->visits(i);
    for (size_t n = 0; n < visits.size(); ++n) {
      const RolloutVisit& v = visits[n];
      visit(r, v.key, archive_.find(v.key), v.world, device_->visitBodies(i, n), v.ticks);
    }
  }
  return {};
}

// The size of a round grows with the steps done, which do not depend on the number of threads.
uint32_t GoExplore::roundSize() const {
  uint32_t size = settings_.rollouts;
  while (size < settings_.maxRollouts && statistics_.steps > size * kStepsPerRollout) size *= 2;
  return size;
}

void GoExplore::chooseCells() {
  choices_.assign(roundSize(), {0, setup_.rules.ticks});
  rollouts_.resize(choices_.size());
  Random random(seed_, kSelectionStream | statistics_.rounds);
  archive_.nextEpoch();
  selector_->choose(archive_, machine_.pool, random, choices_);
  for (size_t i = 0; i < choices_.size(); ++i) {
    Rollout& r = rollouts_[i];
    r.id = nextRollout_++ | choices_[i].by;
    r.start = choices_[i];
    r.parent = archive_.node(r.start.cell);
  }
}

void GoExplore::explore(std::span<Rollout> rollouts) {
  RolloutGroup group(context());
  std::vector<Trail> trails;
  std::vector<Look> looks;
  for (Rollout& r : rollouts) {
    const sim::World& start = archive_.world(r.start.cell);
    const auto bodies = archive_.bodies(r.start.cell);
    r.candidates.clear();
    r.closestTicks = 0;
    r.closest = {};
    r.endBodies.assign(bodies.begin(), bodies.end());
    const uint64_t key = cellKey(setup_.rules.binning, start, r.endBodies.data());
    trails.push_back({key, key});
    archive_.countSeen(r.start.cell);
    group.add(seed_, r.id, start, r.endBodies.data(), r.start.ticks);
  }
  group.run(
      [&](uint32_t tick) {
        if (tick % setup_.rules.rule.lookEvery != 0) return;
        listLooks(group, trails, looks);
        look(group, rollouts, trails, looks, tick);
      },
      [&](uint32_t tick, size_t member) {
        Rollout& r = rollouts[group.index(member)];
        r.end = group.world(member);
        r.ticks = tick;
      });
}

// Lists the rollouts whose cell has changed since the last look, or whose state may now be worth
// keeping. The archive is far larger than the caches, so its entries are prefetched here.
void GoExplore::listLooks(const RolloutGroup& group, std::span<const Trail> trails,
                          std::vector<Look>& looks) const {
  looks.clear();
  for (size_t i = 0; i < group.size(); ++i) {
    const sim::World& world = group.world(i);
    if (world.outcome != sim::Outcome::running) continue;
    const Trail& trail = trails[group.index(i)];
    const uint64_t key = cellKey(setup_.rules.binning, world, group.bodies(i));
    const bool isNew = trail.isNew(key, setup_.rules.rule, world);
    if (!isNew && key == trail.last) continue;
    looks.push_back({key, uint32_t(i), isNew});
    if (isNew) archive_.prefetch(key);
  }
  for (const Look& l : looks) {
    if (l.isNew) archive_.prefetchCell(l.key);
  }
}

void GoExplore::look(const RolloutGroup& group, std::span<Rollout> rollouts,
                     std::span<Trail> trails, std::span<const Look> looks, uint32_t tick) {
  for (const Look& l : looks) {
    Rollout& r = rollouts[group.index(l.member)];
    Trail& trail = trails[group.index(l.member)];
    const sim::World& world = group.world(l.member);
    if (l.isNew) {
      visit(r, l.key, archive_.find(l.key), world, r.endBodies, tick);
      trail.kept = l.key;
    }
    if (l.key == trail.last) continue;
    trail.last = l.key;
    noteClosest(r, world, tick);
  }
}

// Counts a visit to a cell. Notes the state if the archive would keep it.
void GoExplore::visit(Rollout& r, uint64_t key, uint32_t cell, const sim::World& world,
                      std::span<const sim::RigidBody> bodies, uint32_t ticks) {
  if (cell != kNone) {
    archive_.countSeen(cell);
    if (cell != r.start.cell) archive_.noteSighted(cell);
    if (!archive_.better(cell, world)) return;
  }
  Candidate& c = r.candidates.emplace_back();
  c.key = key;
  c.world = world;
  if (!bodies.empty() && !archive_.isFirstBody(bodies.data()))
    c.bodies.assign(bodies.begin(), bodies.end());
  c.potential = setup_.potential(world);
  c.ticks = ticks;
}

void GoExplore::noteClosest(Rollout& r, const sim::World& world, uint32_t tick) {
  const Approach here = approachOf(problem_.query, world);
  if (!closer(here, r.closest)) return;
  r.closest = here;
  r.closestTicks = tick;
}

void GoExplore::merge() {
  tried_.clear();
  for (const Rollout& r : rollouts_) {
    tried_.push_back(keep(r));
    ++statistics_.rollouts;
    ++statistics_.idleRollouts;
    if (tried_.back().cells != 0) statistics_.idleRollouts = 0;
    statistics_.steps += r.ticks;
    countEnd(r.end, r.endBodies.data(), {r.id, r.parent, r.ticks});
    countApproach(r.closest, {r.id, r.parent, r.closestTicks});
  }
  takeGoals();
  selector_->learn(archive_, tried_);
}

Tried GoExplore::keep(const Rollout& r) {
  Tried tried{r.start.cell, archive_.cellCount(), 0, 0};
  std::optional<Companions::Walk> walk;
  if (!companions_.empty() && !r.candidates.empty()) walk.emplace(companions_, r.parent, r.id);
  for (const Candidate& c : r.candidates) {
    if (!offer(r, c, walk ? &*walk : nullptr)) continue;
    tried.potential = std::max(tried.potential, c.potential);
  }
  tried.cells = archive_.cellCount() - tried.firstCell;
  return tried;
}

// Offers a candidate to the archive. With companions it is kept only if they can follow.
bool GoExplore::offer(const Rollout& r, const Candidate& c, Companions::Walk* walk) {
  if (walk != nullptr) {
    const uint32_t cell = archive_.find(c.key);
    if (cell != kNone && !archive_.better(cell, c.world)) return false;
    if (!walk->follow(c.ticks)) return false;
  }
  const Node node{r.id, r.parent, c.ticks};
  const sim::RigidBody* const bodies = c.bodies.empty() ? archive_.firstBodies() : c.bodies.data();
  if (!archive_.offer(c.key, c.world, node, c.potential, bodies)) return false;
  if (walk != nullptr) companions_.keep(archive_.node(archive_.find(c.key)), *walk);
  return true;
}

}  // namespace obby::solve
