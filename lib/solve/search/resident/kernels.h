// The kernels of a resident search, each for one index: choose, explore, claim, place. A kernel
// reads only the results of earlier kernels, and atomic integers whose values do not depend on the
// order of the threads. So a round's result is the same on every machine.
#pragma once

#include "solve/search/resident/round_view.h"
#include "solve/search/rollouts/blame.h"
#include "solve/search/selectors/selection_weight.h"

namespace obby::solve {

OBBY_DEVICE uint32_t cellWeight(const ResidentArguments& a, uint32_t cell) {
  return selectionWeight(a.archive.potentials[cell], a.best, a.archive.seen[cell], kHedge);
}

// Computes sum i of the lowest level of the cells' weights.
OBBY_DEVICE void weighCells(const ResidentArguments& a, uint32_t i) {
  sumLeaves(a.weights, i, [&](uint32_t cell) { return cellWeight(a, cell); });
}

OBBY_DEVICE uint32_t beamRank(const ResidentArguments& a, uint32_t cell) {
  const uint32_t ticks = uint32_t(a.archive.ranks[cell] >> 16);
  const uint32_t rank = (ticks + a.archive.waits[cell]) / kRankTicks;
  return rank < kRanks ? rank : kRanks - 1;
}

// Counts the ranks of 64 cells.
OBBY_DEVICE void countRanks(const ResidentArguments& a, uint32_t i) {
  const uint32_t end = a.archive.cellCount - i * kFan < kFan ? a.archive.cellCount : (i + 1) * kFan;
  for (uint32_t cell = i * kFan; cell < end; ++cell) {
    fetchAdd(a.rankCounts + beamRank(a, cell), 1u);
  }
}

OBBY_DEVICE void sumRanks(const ResidentArguments& a, uint32_t i) {
  sumLeaves(a.rankSums, i, [&](uint32_t rank) { return a.rankCounts[rank]; });
}

// Returns the last rank of the beam. The beam takes all cells up to it, so their order does not
// matter.
OBBY_DEVICE uint32_t lastRank(const ResidentArguments& a) {
  const uint32_t cells = a.archive.cellCount;
  const uint32_t width = a.beamWidth < cells ? a.beamWidth : cells;
  return leafAt(a.rankSums, width - 1, [&](uint32_t rank) { return a.rankCounts[rank]; });
}

// Computes sum i of the lowest level of the beam's cells.
OBBY_DEVICE void markBest(const ResidentArguments& a, uint32_t i) {
  const uint32_t last = lastRank(a);
  sumLeaves(a.bestCells, i, [&](uint32_t cell) { return beamRank(a, cell) <= last ? 1u : 0u; });
}

// Chooses the cell from which rollout i starts.
OBBY_DEVICE void chooseStart(const ResidentArguments& a, uint32_t i) {
  Random random(a.rules.seed, kSelectionStream | (a.firstRollout + i));
  if (i >= a.firstBeam) {
    const uint32_t last = lastRank(a);
    a.starts[i] = leafAt(a.bestCells, drawBelow(random, totalOf(a.bestCells)),
                         [&](uint32_t cell) { return beamRank(a, cell) <= last ? 1u : 0u; });
    return;
  }
  const uint64_t rest = drawBelow(random, totalOf(a.weights));
  a.starts[i] = leafAt(a.weights, rest, [&](uint32_t cell) { return cellWeight(a, cell); });
}

// Counts a visit. Returns true if the archive, as it was before the round, would keep the state.
OBBY_DEVICE bool wouldKeep(const ArchiveView& archive, uint32_t start, uint32_t cell,
                           const sim::World& w, RoundReport& report) {
  if (cell == kNone) return true;
  fetchAdd(archive.seen + cell, 1u);
  if (cell != start && noteSighted(archive, cell)) fetchAdd(&report.sightings, 1u);
  return arrivalRank(w) < archive.ranks[cell];
}

OBBY_DEVICE void noteGoal(const ResidentArguments& a, uint32_t i, const sim::World& w) {
  const ResidentEnd& end = a.ends[i];
  a.goals[fetchAdd(&a.report->goals, 1u)] = {arrivalRank(w), i, end.parent, end.ticks};
}

// Stores how rollout i ended and updates the report. `bodies`: see partThatHurts().
OBBY_DEVICE void noteEnd(const ResidentArguments& a, uint32_t i, const sim::World& w,
                         const sim::RigidBody* bodies, const RolloutPath& path, uint32_t parent,
                         uint32_t candidates) {
  const bool falls = fallsOn(a.rules.context, w);
  const sim::Outcome outcome = falls ? sim::Outcome::fell : w.outcome;
  const uint32_t blamed = blamedPart(w, bodies, a.rules.context.level);
  a.ends[i] = {
      path.closest, w.position, path.closestTicks, path.ticks, falls ? kFallTicks : path.ticks,
      parent,       blamed,     candidates,        outcome};
  if (outcome == sim::Outcome::goal) {
    noteGoal(a, i, w);
  } else {
    const uint32_t part = blamed < a.endParts - 1 ? blamed : a.endParts - 1;
    fetchAdd(a.endCounts + uint32_t(outcome) * a.endParts + part, 1u);
  }
  fetchAdd(&a.report->steps, uint64_t(path.ticks));
  fetchAdd(&a.report->candidates, candidates);
  lower(&a.report->closest, closestRank(path.closest));
  const uint32_t overruns = w.flags & sim::kOverruns;
  if (overruns != 0) fetchOr(&a.report->overruns, overruns);
}

// Runs rollout i and stores its candidates and its end. `kDynamic`: see sim::tick.
template <bool kDynamic>
OBBY_DEVICE void exploreFrom(const ResidentArguments& a, uint32_t i) {
  const uint32_t start = a.starts[i], bodyCount = a.archive.bodyCount;
  const CandidateView& c = a.candidates;
  sim::World world = a.archive.worlds[start];
  sim::RigidBody* const bodies = a.bodies + size_t(i) * bodyCount;
  for (uint32_t b = 0; b < bodyCount; ++b)
    bodies[b] = a.archive.bodies[size_t(start) * bodyCount + b];
  fetchAdd(a.archive.seen + start, 1u);
  if (i >= a.firstBeam) fetchAdd(a.archive.waits + start, kTriedTicks / kBeamTries);
  uint32_t count = 0;
  const auto visit = [&](uint64_t key, const sim::World& w, uint32_t tick) {
    const uint32_t cell = cellOf(a.archive, key);
    if (!wouldKeep(a.archive, start, cell, w, *a.report)) return;
    const size_t at = size_t(i) * a.capacity + count++;
    c.worlds[at] = w;
    c.keys[at] = key;
    c.ticks[at] = tick;
    c.cells[at] = cell;
    for (uint32_t b = 0; b < bodyCount; ++b) c.bodies[at * bodyCount + b] = bodies[b];
  };
  const RolloutPath path =
      explore<kDynamic>(a.rules, a.firstRollout + i, a.rules.ticks, world, bodies, visit);
  noteEnd(a, i, world, bodies, path, a.archive.nodes[start], count);
}

// Does the same as exploreFrom() for a trajectory that the host has played from the start. It keeps
// the visits that the archive would keep.
OBBY_DEVICE void takePlayed(const ResidentArguments& a, uint32_t i) {
  const PlayedStart& played = a.played[i];
  const CandidateView& c = a.candidates;
  const uint32_t bodyCount = a.archive.bodyCount;
  uint32_t count = 0;
  for (uint32_t n = 0; n < played.visits; ++n) {
    const size_t from = size_t(i) * a.capacity + n, at = size_t(i) * a.capacity + count;
    const uint32_t cell = cellOf(a.archive, c.keys[from]);
    if (!wouldKeep(a.archive, 0, cell, c.worlds[from], *a.report)) continue;
    c.worlds[at] = c.worlds[from];
    c.keys[at] = c.keys[from];
    c.ticks[at] = c.ticks[from];
    c.cells[at] = cell;
    for (uint32_t b = 0; b < bodyCount; ++b)
      c.bodies[at * bodyCount + b] = c.bodies[from * bodyCount + b];
    ++count;
  }
  noteEnd(a, i, played.end, nullptr, played.path, 0, count);
}

// Enters the candidates of rollout i into the claims for their cells.
OBBY_DEVICE void claimCells(const ResidentArguments& a, uint32_t i) {
  const ClaimView& claims = a.claims;
  for (uint32_t n = 0; n < a.ends[i].candidates; ++n) {
    const size_t at = size_t(i) * a.capacity + n;
    const uint64_t key = a.candidates.keys[at];
    uint32_t s = uint32_t(key) & claims.slotMask;
    for (;; s = (s + 1) & claims.slotMask) {
      const uint64_t there = compareExchange(claims.keys + s, 0, key);
      if (there == 0 || there == key) break;
    }
    a.candidates.slots[at] = s;
    lower(claims.ranks + s, arrivalRank(a.candidates.worlds[at]));
  }
}

// Finds the winner of each claim of rollout i. The first candidate wins a tie between arrivals.
OBBY_DEVICE void settleClaims(const ResidentArguments& a, uint32_t i) {
  for (uint32_t n = 0; n < a.ends[i].candidates; ++n) {
    const uint32_t at = i * a.capacity + n, s = a.candidates.slots[at];
    if (a.claims.ranks[s] == arrivalRank(a.candidates.worlds[at]))
      lower(a.claims.candidates + s, at);
  }
}

OBBY_DEVICE bool wins(const ResidentArguments& a, uint32_t candidate) {
  return a.claims.candidates[a.candidates.slots[candidate]] == candidate;
}

// Counts the cells that rollout i adds to the archive or improves.
OBBY_DEVICE void countFinds(const ResidentArguments& a, uint32_t i) {
  uint64_t finds = 0;
  for (uint32_t n = 0; n < a.ends[i].candidates; ++n) {
    const uint32_t at = i * a.capacity + n, s = a.candidates.slots[at];
    if (wins(a, at)) {
      finds += a.candidates.cells[at] == kNone ? 1ull << 32 : 1;
    } else if (a.claims.candidates[s] / a.capacity != i) {
      storeRelaxed(a.claims.shared + s, 1);
    }
  }
  a.finds[i] = finds;
  if (closestRank(a.ends[i].closest) == a.report->closest) lower(&a.report->closestRollout, i);
}

// Computes sum i of the lowest level of the finds.
OBBY_DEVICE void sumFinds(const ResidentArguments& a, uint32_t i) {
  sumLeaves(a.findSums, i, [&](uint32_t rollout) { return a.finds[rollout]; });
}

// Stores the state of a candidate in a cell.
OBBY_DEVICE void placeState(const ResidentArguments& a, uint32_t candidate, uint32_t cell,
                            uint32_t node) {
  const ArchiveView& archive = a.archive;
  const sim::World& world = a.candidates.worlds[candidate];
  const uint32_t bodyCount = archive.bodyCount;
  archive.worlds[cell] = world;
  for (uint32_t b = 0; b < bodyCount; ++b) {
    archive.bodies[size_t(cell) * bodyCount + b] =
        a.candidates.bodies[size_t(candidate) * bodyCount + b];
  }
  archive.ranks[cell] = arrivalRank(world);
  archive.nodes[cell] = a.firstNode + node;
  const float potential = potentialOf(a.potential, a.rules.context.query, world);
  archive.potentials[cell] = potential;
  raise(&a.report->bestPotential, floatBits(potential));
}

OBBY_DEVICE void addCell(const ResidentArguments& a, uint32_t candidate, uint32_t cell) {
  addKey(a.archive, a.candidates.keys[candidate], cell);
  a.archive.seen[cell] = 0;
  a.archive.waits[cell] =
      greedyTicks(a.beam, a.rules.context.query, a.candidates.worlds[candidate]);
  if (a.claims.shared[a.candidates.slots[candidate]] != 0 && noteSighted(a.archive, cell)) {
    fetchAdd(&a.report->sightings, 1u);
  }
}

// Stores the finds of rollout i. New cells and nodes are numbered in the order of the rollouts and
// their candidates. Cells beyond the capacity of the archive are not kept.
OBBY_DEVICE void placeFinds(const ResidentArguments& a, uint32_t i) {
  const uint64_t before = sumBefore(a.findSums, i, [&](uint32_t r) { return a.finds[r]; });
  const uint32_t cellsBefore = uint32_t(before >> 32);
  uint32_t added = cellsBefore < a.freeCells ? cellsBefore : a.freeCells;
  uint32_t node = added + uint32_t(before);
  const uint32_t addedBefore = added;
  for (uint32_t n = 0; n < a.ends[i].candidates; ++n) {
    const uint32_t at = i * a.capacity + n;
    if (!wins(a, at)) continue;
    uint32_t cell = a.candidates.cells[at];
    if (cell == kNone) {
      if (added == a.freeCells) continue;
      cell = a.archive.cellCount + added++;
      addCell(a, at, cell);
    }
    placeState(a, at, cell, node);
    a.nodes[node++] = {a.firstRollout + i, a.ends[i].parent, a.candidates.ticks[at]};
  }
  if (added != addedBefore) raise(&a.report->lastFinder, i + 1);
}

// Computes one sum of a level above the lowest.
OBBY_DEVICE void sumOne(const SumArguments& a, uint32_t i) { sumLevel(a.tree, a.level, i); }

// Copies slot i of a smaller table into the table of `archive`.
OBBY_DEVICE void rehash(const RehashArguments& a, uint32_t i) {
  if (a.slots[i].key != 0) addKey(a.archive, a.slots[i].key, a.slots[i].cell);
}

}  // namespace obby::solve
