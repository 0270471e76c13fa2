#include "solve/search/resident/resident_explore.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr uint64_t kResidentSteps =
    1000;  // steps so far per rollout of a round; then rounds double
constexpr uint64_t kArchiveBytes = 4ull << 30;    // budget of the archive
constexpr uint64_t kCandidateBytes = 1ull << 30;  // budget of a round's candidates

uint64_t stateBytes(const Problem& problem) {
  return sizeof(sim::World) + problem.level.bodyCount * sizeof(sim::RigidBody);
}

uint32_t fittingCells(const Problem& problem, uint32_t max) {
  constexpr uint64_t kOtherBytes =
      2 * sizeof(CellSlot) + 48;  // table, sums, other arrays of a cell
  return uint32_t(std::min<uint64_t>(max, kArchiveBytes / (stateBytes(problem) + kOtherBytes)));
}

uint32_t fittingRollouts(const Problem& problem, const RolloutRules& rules, uint32_t max) {
  const uint64_t each = visitCapacity(rules) * (stateBytes(problem) + 24);
  while (max > 1 && max * each > kCandidateBytes) max /= 2;
  return max;
}

}  // namespace

ResidentExplore::ResidentExplore(const Problem& problem, uint64_t seed,
                                 const ResidentSettings& settings, const Machine& machine)
    : problem_(problem),
      settings_(settings),
      machine_(machine),
      setup_(problem, seed, settings.explore),
      maxRollouts_(fittingRollouts(problem, setup_.rules, settings.explore.maxRollouts)),
      maxCells_(fittingCells(problem, settings.maxCells)),
      host_(machine.pool) {
  restart();
}

void ResidentExplore::restart() {
  rounds_.reset();
  nodes_ = {};
  nodes_.push_back({0, kNone, 0});
  cells_ = 1;
  sightings_ = 0;
  nextRollout_ = 0;
  goals_.clear();
  attempts_ = {};
  statistics_ = {};
  statistics_.closest.distance = distanceLeft(problem_.query, problem_.start);
  statistics_.closest.position = problem_.start.position;
}

Status ResidentExplore::open() {
  if (rounds_) return {};
  sim::Device& device = machine_.device != nullptr ? *machine_.device : host_;
  OBBY_ASSIGN(rounds_, ResidentRounds::open(device, setup_, problem_, maxCells_));
  for (const auto& [first, count] : known_) OBBY_RETURN_IF_ERROR(follow(first, count));
  return {};
}

void ResidentExplore::round() {
  onDevice([&] { return doRound(); });
}

Status ResidentExplore::doRound() {
  OBBY_RETURN_IF_ERROR(open());
  const uint32_t rollouts = roundSize();
  OBBY_ASSIGN(const RoundFindings found, rounds_->run(nextRollout_, rollouts));
  take(found, nextRollout_, rollouts);
  nextRollout_ += rollouts;
  ++statistics_.rounds;
  return {};
}

// The size of a round grows with the steps done, which are the same on every machine.
uint32_t ResidentExplore::roundSize() const {
  uint32_t size = std::min(settings_.explore.rollouts, maxRollouts_);
  while (size < maxRollouts_ && statistics_.steps > size * kResidentSteps) size *= 2;
  return std::min(size, maxRollouts_);
}

void ResidentExplore::take(const RoundFindings& found, uint64_t firstRollout, uint32_t rollouts) {
  const RoundReport& report = found.report;
  for (const Node& node : found.nodes) nodes_.push_back(node);
  cells_ = found.cells;
  sightings_ += report.sightings;
  statistics_.steps += report.steps;
  statistics_.rollouts += rollouts;
  statistics_.overruns |= uint8_t(report.overruns);
  statistics_.idleRollouts =
      report.lastFinder == 0 ? statistics_.idleRollouts + rollouts : rollouts - report.lastFinder;
  if (closer(found.closest.closest, statistics_.closest)) {
    const ResidentEnd& end = found.closest;
    statistics_.closest = {end.closest,
                           {firstRollout + report.closestRollout, end.parent, end.closestTicks}};
  }
  goals_.clear();
  for (const GoalReached& g : found.goals) {
    goals_.push_back({firstRollout + g.rollout, g.parent, g.ticks});
  }
  takeEnds(found, firstRollout);
}

void ResidentExplore::takeEnds(const RoundFindings& found, uint64_t firstRollout) {
  const uint32_t parts = rounds_->endParts();
  for (uint32_t i = 0; i < found.endCounts.size(); ++i) {
    if (found.endCounts[i] == 0) continue;
    const uint32_t part = i % parts == parts - 1 ? kNone : i % parts;
    attempts_.count(sim::Outcome(i / parts), part, found.endCounts[i]);
  }
  for (size_t i = 0; i < found.ends.size(); ++i) {
    const ResidentEnd& end = found.ends[i];
    if (end.outcome == sim::Outcome::goal) continue;
    attempts_.show(
        {{firstRollout + i, end.parent, end.pathTicks}, end.position, end.outcome, end.part});
  }
}

// Returns the start if the device cannot be read any more.
Node ResidentExplore::newest() const {
  if (!rounds_) return nodes_[0];
  const auto cells = rounds_->cells(cells_ - 1);
  return nodes_[cells && !cells->empty() ? cells->front().node : 0];
}

// Returns an empty list if the device cannot be read. The next call then asks for these cells, too.
std::vector<Vec3> ResidentExplore::places(uint32_t first) const {
  std::vector<Vec3> result;
  if (!rounds_) return result;
  const auto cells = rounds_->cells(first);
  if (!cells) return result;
  for (const ArchivedCell& c : *cells) result.push_back(c.world.position);
  return result;
}

std::vector<ArchivedCell> ResidentExplore::cells() const {
  if (!rounds_) return {};
  auto cells = rounds_->cells(0);
  return cells ? *std::move(cells) : std::vector<ArchivedCell>{};
}

}  // namespace obby::solve
