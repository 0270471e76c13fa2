#include "solve/search/resident/resident_rounds.h"

#include <algorithm>
#include <bit>

namespace obby::solve {

namespace {

constexpr uint32_t kShownEnds = 1024;  // rollouts of a round whose ends may be shown
constexpr uint32_t kMinSlots = 64;     // min slots in the table of claims

// Returns the number of possible values of World::part: the larger of the numbers of the level's
// parts and the query's avoid regions, plus one for kNone.
uint32_t endPartsOf(const ExploreContext& c) {
  uint32_t parts = c.query.avoidCount;
  for (uint32_t i = 0; i < c.level.colliderCount; ++i) {
    parts = std::max(parts, c.level.colliders[i].part + 1);
  }
  return parts + 1;
}

struct Tables {
  RolloutRules rules;
  PotentialView potential;
  BeamView beam;
};

template <class Table>
void forTables(Tables& t, Table&& table) {
  forTables(t.rules, table);
  forTables(t.potential, table);
  forTables(t.beam, table);
}

}  // namespace

ResidentRounds::ResidentRounds(sim::Device& device, const ExploreSetup& setup,
                               const Problem& problem, uint32_t maxCells)
    : device_(&device), maxCells_(maxCells), archive_(device, problem.level.bodyCount) {
  arguments_.rules = setup.rules;
  arguments_.potential = setup.potential.view();
  arguments_.beam = setup.beam.view();
  arguments_.endParts = endPartsOf(setup.rules.context);
  arguments_.firstNode = 1;  // the start has node 0
}

Result<ResidentRounds> ResidentRounds::open(sim::Device& device, const ExploreSetup& setup,
                                            const Problem& problem, uint32_t maxCells) {
  ResidentRounds rounds(device, setup, problem, maxCells);
  OBBY_RETURN_IF_ERROR(rounds.openTables(setup, problem));
  return rounds;
}

Status ResidentRounds::openTables(const ExploreSetup& setup, const Problem& problem) {
  const uint64_t key = cellKey(arguments_.rules.binning, problem.start, problem.startBodies.data());
  const float potential = setup.potential(problem.start);
  const uint32_t wait = greedyTicks(setup.beam.view(), problem.query, problem.start);
  OBBY_RETURN_IF_ERROR(archive_.addStart(problem, key, potential, wait));
  arguments_.best = potential;
  Tables tables{arguments_.rules, arguments_.potential, arguments_.beam};
  OBBY_ASSIGN(memory_.tables, sim::uploadTables(*device_, tables));
  arguments_.rules = tables.rules;
  arguments_.potential = tables.potential;
  arguments_.beam = tables.beam;
  return {};
}

Status ResidentRounds::launch(ResidentStep step, uint32_t count) const {
  return device_->launch(residentKernel(step), &arguments_, count);
}

// Computes all levels above the lowest.
Status ResidentRounds::sumUp(const SumTree& tree) const {
  SumArguments arguments{tree, 1};
  for (; arguments.level < tree.levels; ++arguments.level) {
    OBBY_RETURN_IF_ERROR(device_->launch(residentKernel(ResidentStep::sum), &arguments,
                                         sumCount(tree, arguments.level)));
  }
  return {};
}

Status ResidentRounds::reserveRound(uint32_t rollouts, uint32_t visits) {
  ResidentArguments& a = arguments_;
  const size_t bodyCount = a.archive.bodyCount, all = size_t(rollouts) * visits;
  OBBY_RETURN_IF_ERROR(reserve(memory_.starts, a.starts, rollouts));
  OBBY_RETURN_IF_ERROR(reserve(memory_.bodies, a.bodies, rollouts * bodyCount));
  OBBY_RETURN_IF_ERROR(reserve(memory_.worlds, a.candidates.worlds, all));
  OBBY_RETURN_IF_ERROR(reserve(memory_.candidateBodies, a.candidates.bodies, all * bodyCount));
  OBBY_RETURN_IF_ERROR(reserve(memory_.keys, a.candidates.keys, all));
  OBBY_RETURN_IF_ERROR(reserve(memory_.ticks, a.candidates.ticks, all));
  OBBY_RETURN_IF_ERROR(reserve(memory_.cells, a.candidates.cells, all));
  OBBY_RETURN_IF_ERROR(reserve(memory_.slots, a.candidates.slots, all));
  OBBY_RETURN_IF_ERROR(reserve(memory_.finds, a.finds, rollouts));
  OBBY_RETURN_IF_ERROR(reserve(memory_.ends, a.ends, rollouts));
  OBBY_RETURN_IF_ERROR(reserve(memory_.goals, a.goals, rollouts));
  OBBY_RETURN_IF_ERROR(reserve(memory_.endCounts, a.endCounts, size_t(kOutcomes) * a.endParts));
  OBBY_RETURN_IF_ERROR(reserve(memory_.report, a.report, 1));
  a.findSums = makeSumTree(nullptr, rollouts);
  return reserve(memory_.findSums, a.findSums.sums, a.findSums.firsts[a.findSums.levels]);
}

Status ResidentRounds::begin(uint64_t firstRollout, uint32_t rollouts, uint32_t visits) {
  ResidentArguments& a = arguments_;
  a.firstRollout = firstRollout;
  a.capacity = visits;
  a.archive = archive_.view();
  OBBY_RETURN_IF_ERROR(reserveRound(rollouts, visits));
  OBBY_RETURN_IF_ERROR(device_->fill(a.endCounts, 0, memory_.endCounts.bytes()));
  RoundReport fresh{};
  fresh.closest = ~0ull;
  fresh.closestRollout = kNone;
  fresh.bestPotential = floatBits(a.best);
  return device_->upload(a.report, &fresh, sizeof fresh);
}

// Ranks the cells for the second half of the rollouts, which start from the beam.
Status ResidentRounds::rankCells(uint32_t rollouts) {
  ResidentArguments& a = arguments_;
  a.firstBeam = (rollouts + 1) / 2;
  a.beamWidth = std::max(1u, (rollouts - a.firstBeam) / kBeamTries);
  a.bestCells = archive_.bestCells();
  a.rankSums = makeSumTree(nullptr, kRanks);
  OBBY_RETURN_IF_ERROR(reserve(memory_.rankCounts, a.rankCounts, kRanks));
  OBBY_RETURN_IF_ERROR(
      reserve(memory_.rankSums, a.rankSums.sums, a.rankSums.firsts[a.rankSums.levels]));
  OBBY_RETURN_IF_ERROR(device_->fill(a.rankCounts, 0, memory_.rankCounts.bytes()));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::countRanks, sumCount(a.bestCells, 0)));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::sumRanks, sumCount(a.rankSums, 0)));
  OBBY_RETURN_IF_ERROR(sumUp(a.rankSums));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::markBest, sumCount(a.bestCells, 0)));
  return sumUp(a.bestCells);
}

Status ResidentRounds::chooseStarts(uint32_t rollouts) {
  arguments_.weights = archive_.weights();
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::weigh, sumCount(arguments_.weights, 0)));
  OBBY_RETURN_IF_ERROR(sumUp(arguments_.weights));
  OBBY_RETURN_IF_ERROR(rankCells(rollouts));
  return launch(ResidentStep::choose, rollouts);
}

Result<RoundFindings> ResidentRounds::run(uint64_t firstRollout, uint32_t rollouts) {
  OBBY_RETURN_IF_ERROR(begin(firstRollout, rollouts, visitCapacity(arguments_.rules)));
  OBBY_RETURN_IF_ERROR(chooseStarts(rollouts));
  const bool bodies = arguments_.archive.bodyCount != 0;
  OBBY_RETURN_IF_ERROR(
      launch(bodies ? ResidentStep::exploreDynamic : ResidentStep::explore, rollouts));
  return merge(rollouts);
}

Result<RoundFindings> ResidentRounds::take(uint64_t firstRollout, const PlayedStarts& played) {
  const uint32_t count = uint32_t(played.trajectories.size());
  OBBY_RETURN_IF_ERROR(begin(firstRollout, count, played.capacity));
  OBBY_RETURN_IF_ERROR(
      sim::uploadTable<PlayedStart>(*device_, memory_.played, played.trajectories));
  OBBY_RETURN_IF_ERROR(sim::uploadTable<sim::World>(*device_, memory_.worlds, played.worlds));
  OBBY_RETURN_IF_ERROR(
      sim::uploadTable<sim::RigidBody>(*device_, memory_.candidateBodies, played.bodies));
  OBBY_RETURN_IF_ERROR(sim::uploadTable<uint64_t>(*device_, memory_.keys, played.keys));
  OBBY_RETURN_IF_ERROR(sim::uploadTable<uint32_t>(*device_, memory_.ticks, played.ticks));
  arguments_.played = memory_.played.as<PlayedStart>();
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::takePlayed, count));
  return merge(count);
}

// Makes a table of claims that is at most half full.
Status ResidentRounds::makeClaims(uint32_t candidates) {
  ClaimView& c = arguments_.claims;
  const uint32_t slots = std::max(kMinSlots, std::bit_ceil(2 * candidates));
  OBBY_RETURN_IF_ERROR(reserve(memory_.claimKeys, c.keys, slots));
  OBBY_RETURN_IF_ERROR(reserve(memory_.claimRanks, c.ranks, slots));
  OBBY_RETURN_IF_ERROR(reserve(memory_.claimants, c.candidates, slots));
  OBBY_RETURN_IF_ERROR(reserve(memory_.shared, c.shared, slots));
  c.slotMask = slots - 1;
  OBBY_RETURN_IF_ERROR(device_->fill(c.keys, 0, slots * sizeof(uint64_t)));
  OBBY_RETURN_IF_ERROR(device_->fill(c.ranks, 0xff, slots * sizeof(uint64_t)));
  OBBY_RETURN_IF_ERROR(device_->fill(c.candidates, 0xff, slots * sizeof(uint32_t)));
  return device_->fill(c.shared, 0, slots * sizeof(uint32_t));
}

Status ResidentRounds::claim(uint32_t rollouts) {
  RoundReport report{};
  OBBY_RETURN_IF_ERROR(device_->download(&report, arguments_.report, sizeof report));
  OBBY_RETURN_IF_ERROR(makeClaims(report.candidates));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::claim, rollouts));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::settle, rollouts));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::count, rollouts));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::sumFinds, sumCount(arguments_.findSums, 0)));
  return sumUp(arguments_.findSums);
}

// Grows the archive by the number of finds, then stores them.
Status ResidentRounds::place(uint32_t rollouts, RoundFindings& findings) {
  ResidentArguments& a = arguments_;
  const SumTree& sums = a.findSums;
  uint64_t finds = 0;
  OBBY_RETURN_IF_ERROR(
      device_->download(&finds, sums.sums + sums.firsts[sums.levels - 1], sizeof finds));
  const uint32_t cells = a.archive.cellCount;
  a.freeCells = maxCells_ - cells;
  const uint32_t added = std::min(uint32_t(finds >> 32), a.freeCells);
  const uint32_t nodes = added + uint32_t(finds);
  OBBY_RETURN_IF_ERROR(archive_.grow(cells + added));
  a.archive = archive_.view();
  OBBY_RETURN_IF_ERROR(reserve(memory_.nodes, a.nodes, nodes));
  OBBY_RETURN_IF_ERROR(launch(ResidentStep::place, rollouts));
  OBBY_ASSIGN(findings.nodes, sim::downloadTable(*device_, a.nodes, nodes));
  findings.cells = cells + added;
  return {};
}

Status ResidentRounds::collect(uint32_t rollouts, RoundFindings& f) const {
  const ResidentArguments& a = arguments_;
  const sim::Device& d = *device_;
  OBBY_RETURN_IF_ERROR(d.download(&f.report, a.report, sizeof f.report));
  OBBY_ASSIGN(f.goals, sim::downloadTable(d, a.goals, f.report.goals));
  std::sort(f.goals.begin(), f.goals.end(), [](const GoalReached& x, const GoalReached& y) {
    return x.rank < y.rank || (x.rank == y.rank && x.rollout < y.rollout);
  });
  OBBY_ASSIGN(f.ends, sim::downloadTable(d, a.ends, std::min(rollouts, kShownEnds)));
  OBBY_ASSIGN(f.endCounts, sim::downloadTable(d, a.endCounts, size_t(kOutcomes) * a.endParts));
  return d.download(&f.closest, a.ends + f.report.closestRollout, sizeof f.closest);
}

Result<RoundFindings> ResidentRounds::merge(uint32_t rollouts) {
  RoundFindings findings;
  OBBY_RETURN_IF_ERROR(claim(rollouts));
  OBBY_RETURN_IF_ERROR(place(rollouts, findings));
  OBBY_RETURN_IF_ERROR(collect(rollouts, findings));
  archive_.setCellCount(findings.cells);
  arguments_.firstNode += uint32_t(findings.nodes.size());
  arguments_.best = floatOf(findings.report.bestPotential);
  return findings;
}

Result<std::vector<ArchivedCell>> ResidentRounds::cells(uint32_t first) const {
  const ArchiveView& v = archive_.view();
  const size_t bodyCount = v.bodyCount;
  std::vector<ArchivedCell> result;
  if (first >= v.cellCount) return result;
  const uint32_t count = v.cellCount - first;
  OBBY_ASSIGN(const auto worlds, sim::downloadTable(*device_, v.worlds + first, count));
  OBBY_ASSIGN(const auto bodies,
              sim::downloadTable(*device_, v.bodies + first * bodyCount, count * bodyCount));
  OBBY_ASSIGN(const auto nodes, sim::downloadTable(*device_, v.nodes + first, count));
  OBBY_ASSIGN(const auto seen, sim::downloadTable(*device_, v.seen + first, count));
  for (uint32_t i = 0; i < count; ++i) {
    const auto body = bodies.begin() + ptrdiff_t(i * bodyCount);
    result.push_back({worlds[i], {body, body + ptrdiff_t(bodyCount)}, nodes[i], seen[i]});
  }
  return result;
}

}  // namespace obby::solve
