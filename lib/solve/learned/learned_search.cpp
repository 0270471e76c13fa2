#include "solve/learned/learned_search.h"

#include <algorithm>

#include "sim/simulator.h"
#include "solve/go_explore_method.h"
#include "solve/rollouts/known_way.h"

namespace obby::solve::learned {

LearnedSearch::LearnedSearch(const Problem& problem, uint64_t seed, const Machine& machine)
    : ArchiveSearch(problem, seed, plainSettings()),
      pool_(machine.pool),
      surroundings_(problem_.level, policy::kSight),
      around_(surroundings_.view()),
      scene_{problem_.level, problem_.query, around_},
      passed_(problem_.known.size()) {}

void LearnedSearch::round() {
  archive_.nextEpoch();
  playAndLearn();
  takeGoals();
  ++statistics_.rounds;
}

Episode LearnedSearch::begin() const {
  Episode e;
  e.world = problem_.start;
  e.loose = problem_.startLoose;
  e.key = cellKey(setup_.rules.binning, e.world, e.loose.data());
  e.cell = archive_.find(e.key);
  e.been.insert(e.key);
  e.stood.insert(e.key);
  return e;
}

uint64_t LearnedSearch::keyAt(const Episode& e, Vec3 place) const {
  sim::World world = e.world;
  world.position = place;
  return cellKey(setup_.rules.binning, world, e.loose.data());
}

sim::Action LearnedSearch::allowed(sim::Action action, const sim::World& world) const {
  if (context().jumpsLimited && action.jump && sim::jumpsLeft(problem_.query, world) == 0) {
    action.jump = false;
  }
  return action;
}

void LearnedSearch::advance(std::span<Episode* const> episodes, const sim::Action* actions) {
  std::vector<sim::World*> worlds;
  std::vector<sim::LooseBody*> loose;
  for (Episode* e : episodes) {
    worlds.push_back(&e->world);
    loose.push_back(e->loose.data());
  }
  sim::advanceAll(problem_.level, &problem_.query, worlds, loose.data(), actions);
  for (size_t i = 0; i < episodes.size(); ++i) {
    Episode& e = *episodes[i];
    hold(e.actions, actions[i]);
    ++e.ticks;
    look(e);
  }
}

void LearnedSearch::look(Episode& e) {
  if (e.world.outcome != sim::Outcome::running) return;
  const uint64_t key = cellKey(setup_.rules.binning, e.world, e.loose.data());
  if (key != e.key) {
    e.key = key;
    e.cell = archive_.find(key);
    if (!e.repeats && e.been.insert(key).second) enter(e);
  }
  if (e.repeats || !grounded(e.world) || !e.stood.insert(key).second) return;
  e.passed.push_back({key, e.world.position, e.ticks});
}

// Once for each cell that the player comes into.
void LearnedSearch::enter(Episode& e) {
  const Approach here = approachOf(problem_.query, e.world);
  if (closer(here, e.closest)) {
    e.closest = here;
    e.closestTicks = e.ticks;
  }
  if (e.cell != kNone) {
    archive_.countSeen(e.cell);
    archive_.noteSighted(e.cell);
    if (!archive_.better(e.cell, e.world)) return;
  } else {
    ++e.newCells;
  }
  e.finds.push_back({e.key, e.world, e.loose, setup_.potential(e.world), e.ticks});
}

void LearnedSearch::take(Episode& e, size_t way) {
  const uint64_t id = kKnown | way;
  const uint32_t cells = cellCount();
  bool needed = false;
  for (const Find& f : e.finds) {
    needed |= archive_.offer(f.key, f.world, {id, 0, f.ticks}, f.potential, f.loose.data());
  }
  ++statistics_.rollouts;
  ++statistics_.idleRollouts;
  if (cellCount() != cells) statistics_.idleRollouts = 0;
  needed |= countApproach(e.closest, {id, 0, e.closestTicks});
  needed |= countEnd(e.world, {id, 0, e.ticks});
  if (!needed) return;
  if (way == problem_.known.size()) {
    problem_.known.push_back(std::move(e.actions));
    passed_.emplace_back();
  }
  passed_[way] = std::move(e.passed);
}

// The ways of an earlier answer are episodes like any other: what they came to is returned to.
void LearnedSearch::tryKnown(size_t first, size_t count) {
  std::vector<Episode> episodes(count);
  pool_.run(int(count), [&](int task) {
    Episode& e = episodes[size_t(task)];
    e = begin();
    const KnownWay& way = problem_.known[first + size_t(task)];
    runKnown(context(), way, e.world, e.loose.data(), ticksOf(way),
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

std::pair<size_t, size_t> LearnedSearch::wayTo(uint32_t cell) const {
  const Node& node = archive_.nodes()[archive_.node(cell)];
  if (node.parent == kNone) return {0, 0};
  const size_t way = node.rollout & ~kKnown;
  const std::vector<Passed>& cells = passed_[way];
  const auto end = std::upper_bound(cells.begin(), cells.end(), node.ticks,
                                    [](uint32_t t, const Passed& p) { return t < p.tick; });
  return {way, size_t(end - cells.begin())};
}

}  // namespace obby::solve::learned
