#include "baselines/learned_search.h"

#include <algorithm>

#include "policy/policy.h"
#include "sim/simulator.h"
#include "solve/search/methods/go_explore_method.h"
#include "solve/search/rollouts/action_runs.h"

namespace obby::baselines {

namespace {

size_t bytesOf(const ActionRuns& actions, const std::vector<Passed>& passed) {
  return actions.capacity() * sizeof(actions[0]) + passed.capacity() * sizeof(Passed);
}

}  // namespace

LearnedSearch::LearnedSearch(const Problem& problem, uint64_t seed, const Machine& machine,
                             uint32_t players, size_t forgetFrom)
    : ArchiveSearch(problem, seed, plainSettings()),
      pool_(machine.pool),
      surroundings_(problem_.level, policy::kSight),
      around_(surroundings_.view()),
      scene_{problem_.level, problem_.query, around_},
      passed_(problem_.known.size()),
      shown_(problem_.known.size(), 1),
      forgetFrom_(forgetFrom) {
  if (machine.device != nullptr)
    device_ = std::make_unique<DeviceWork>(*machine.device, problem_, around_, players);
}

void LearnedSearch::round() {
  archive_.nextEpoch();
  playAndLearn();
  if (device_ && !device_->works()) deviceStatus_ = device_->status();
  forget();
  takeGoals();
  ++statistics_.rounds;
}

Episode LearnedSearch::begin() const {
  Episode e;
  e.world = problem_.start;
  e.bodies = problem_.startBodies;
  e.key = cellKey(setup_.rules.binning, e.world, e.bodies.data());
  e.cell = archive_.find(e.key);
  e.stood.insert(e.key);
  return e;
}

uint64_t LearnedSearch::keyAt(const Episode& e, Vec3 place) const {
  sim::World world = e.world;
  world.position = place;
  return cellKey(setup_.rules.binning, world, e.bodies.data());
}

sim::Action LearnedSearch::allowed(sim::Action action, const sim::World& world) const {
  if (context().jumpsLimited && action.jump && sim::jumpsLeft(problem_.query, world) == 0) {
    action.jump = false;
  }
  return action;
}

void LearnedSearch::forGroups(size_t groups, const std::function<void(size_t, size_t)>& play) {
  if (&pool() == &alone_) {
    play(0, groups);
  } else {
    pool_.run(int(groups), [&](int g) { play(size_t(g), 1); });
  }
}

void LearnedSearch::see(std::span<const View> views, float* inputs, size_t stride) {
  const auto there = [&](DevicePlayers& players, DeviceNets&) {
    return players.see(views, inputs, stride);
  };
  if (device_ && device_->tries(there)) return;
  for (const View& v : views) {
    const sim::NextRegion next{&v.next, geom::distance(v.next, v.player->world.position)};
    policy::observe(scene_, v.player->world, v.player->bodies.data(), next, v.ahead, inputs);
    inputs += stride;
  }
}

void LearnedSearch::advance(std::span<Episode* const> episodes, const sim::Action* actions) {
  tick(episodes, actions);
  for (size_t i = 0; i < episodes.size(); ++i) {
    Episode& e = *episodes[i];
    hold(e.actions, actions[i]);
    ++e.ticks;
    look(e);
  }
}

void LearnedSearch::tick(std::span<Episode* const> episodes, const sim::Action* actions) {
  const auto there = [&](DevicePlayers& players, DeviceNets&) {
    return players.advance(episodes, actions);
  };
  if (device_ && device_->tries(there)) return;
  std::vector<sim::World*> worlds;
  std::vector<sim::RigidBody*> bodies;
  for (Episode* e : episodes) {
    worlds.push_back(&e->world);
    bodies.push_back(e->bodies.data());
  }
  sim::advanceAll(problem_.level, &problem_.query, worlds, bodies.data(), actions);
}

void LearnedSearch::look(Episode& e) {
  if (e.world.outcome != sim::Outcome::running) return;
  const uint64_t key = cellKey(setup_.rules.binning, e.world, e.bodies.data());
  if (key != e.key) {
    e.key = key;
    e.cell = archive_.find(key);
    if (!e.repeats) approach(e);
  }
  if (e.repeats || !grounded(e.world) || !goesOn(e)) return;
  if (e.stood.insert(key).second) stand(e);
}

// Updates the closest approach. Called whenever the player enters a cell, standing or not.
void LearnedSearch::approach(Episode& e) const {
  const Approach here = approachOf(problem_.query, e.world);
  if (!closer(here, e.closest)) return;
  e.closest = here;
  e.closestTicks = e.ticks;
}

// Records a cell. Called once for each cell that the player stands in.
void LearnedSearch::stand(Episode& e) {
  e.passed.push_back({e.key, e.world.position, e.ticks});
  if (e.cell != kNone) {
    archive_.countSeen(e.cell);
    archive_.noteSighted(e.cell);
    if (!archive_.better(e.cell, e.world)) return;
  } else {
    ++e.newCells;
  }
  e.finds.push_back({e.key, e.world, e.bodies, setup_.potential(e.world), e.ticks});
}

void LearnedSearch::take(Episode& e, size_t kept) {
  const uint64_t id = kWarmStart | kept;
  const uint32_t cells = cellCount();
  bool needed = false;
  for (const Find& f : e.finds) {
    needed |= archive_.offer(f.key, f.world, {id, 0, f.ticks}, f.potential, f.bodies.data());
  }
  ++statistics_.rollouts;
  ++statistics_.idleRollouts;
  if (cellCount() != cells) statistics_.idleRollouts = 0;
  needed |= countApproach(e.closest, {id, 0, e.closestTicks});
  const bool shown = countEnd(e.world, e.bodies.data(), {id, 0, e.ticks});
  if (!needed && !shown) return;
  keep(e, kept);
  shown_[kept] |= uint8_t(shown);
}

void LearnedSearch::keep(Episode& e, size_t kept) {
  if (kept == problem_.known.size()) {
    e.actions.shrink_to_fit();
    problem_.known.push_back(std::move(e.actions));
    passed_.emplace_back();
    shown_.push_back(0);
  }
  e.passed.shrink_to_fit();
  passed_[kept] = std::move(e.passed);
  bytesKept_ += bytesOf(problem_.known[kept], passed_[kept]);
}

// Drops unused trajectories. A trajectory is used if it is the best one to a cell or the closest
// approach, if its end may be shown, or if a player follows it. Runs when memory has doubled since
// the last time.
void LearnedSearch::forget() {
  if (bytesKept_ < forgetFrom_) return;
  std::vector<uint8_t> used = shown_;
  const auto mark = [&](const Node& node) {
    if (node.parent != kNone) used[node.rollout & ~kWarmStart] = 1;
  };
  for (uint32_t c = 0; c < cellCount(); ++c) mark(archive_.nodes()[archive_.node(c)]);
  mark(statistics_.closest.node);
  markFollowed(used);
  size_t left = 0;
  for (size_t kept = 0; kept < used.size(); ++kept) {
    if (!used[kept]) {
      ActionRuns().swap(problem_.known[kept]);
      std::vector<Passed>().swap(passed_[kept]);
    }
    left += bytesOf(problem_.known[kept], passed_[kept]);
  }
  bytesKept_ = left;
  forgetFrom_ = std::max(forgetFrom_, 2 * left);
}

// Known trajectories are played like other episodes, so that players can return to their cells.
void LearnedSearch::tryWarmStarts(size_t first, size_t count) {
  std::vector<Episode> episodes(count);
  pool_.run(int(count), [&](int task) {
    Episode& e = episodes[size_t(task)];
    e = begin();
    const ActionRuns& kept = problem_.known[first + size_t(task)];
    playRuns(context(), kept, e.world, e.bodies.data(), ticksOf(kept),
             [&](const sim::Action&, const sim::World&) {
               ++e.ticks;
               look(e);
             });
  });
  for (size_t i = 0; i < count; ++i) {
    statistics_.steps += episodes[i].ticks;
    take(episodes[i], first + i);
  }
  takeGoals();
}

std::pair<size_t, size_t> LearnedSearch::keptTo(uint32_t cell) const {
  const Node& node = archive_.nodes()[archive_.node(cell)];
  if (node.parent == kNone) return {0, 0};
  const size_t kept = node.rollout & ~kWarmStart;
  const std::vector<Passed>& cells = passed_[kept];
  const auto end = std::upper_bound(cells.begin(), cells.end(), node.ticks,
                                    [](uint32_t t, const Passed& p) { return t < p.tick; });
  return {kept, size_t(end - cells.begin())};
}

}  // namespace obby::baselines
