#include "solve/choose_beam.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr size_t kTries = 4;          // rollouts from a cell in a round
constexpr float kGreed = 5;           // more than 1: finds some way sooner, not the shortest
constexpr uint32_t kTriedTicks = 60;  // what a round's tries add to f: no cell waits for ever
constexpr uint32_t kBlock = 4096;     // cells a task of the pool

// Keeps the least `count` of them, in order.
void keepLeast(std::vector<uint64_t>& ranks, size_t count) {
  count = std::min(count, ranks.size());
  std::partial_sort(ranks.begin(), ranks.begin() + std::ptrdiff_t(count), ranks.end());
  ranks.resize(count);
}

}  // namespace

GoExploreSettings beamSettings() { return {}; }

BeamChooser::BeamChooser(const Problem& problem)
    : query_(problem.query),
      ticksPerStud_(float(problem.level.params.controlRate) /
                    std::max(problem.level.params.walkSpeed, 1.0f)),
      legs_(problem.query.waypointCount + 1, 0.0f) {
  const geom::Region* to = &query_.goal.region;
  for (uint32_t i = query_.waypointCount; i-- > 0; to = &query_.waypoints[i].target.region) {
    const geom::Region& from = query_.waypoints[i].target.region;
    const float leg = geom::distance(*to, from.pose.position) - length(from.half);
    // With a choice of goals the leg to the first would not be the least.
    const bool known = i + 1 < query_.waypointCount || query_.otherGoalCount == 0;
    legs_[i] = legs_[i + 1] + (known ? std::max(leg, 0.0f) : 0.0f);
  }
  for (uint32_t i = 0; i < query_.visitCount; ++i) {
    const geom::Region& from = query_.visits[i].region;
    float nearest = geom::distance(query_.goal.region, from.pose.position);
    for (uint32_t k = 0; k < query_.visitCount; ++k) {
      if (k == i) continue;
      nearest = std::min(nearest, geom::distance(query_.visits[k].region, from.pose.position));
    }
    hops_.push_back(nearest);
  }
}

float BeamChooser::ticksLeft(const sim::World& world) const {
  float studs = distanceLeft(query_, world) + legs_[world.waypoints];
  for (uint32_t i = 0; i < query_.visitCount; ++i) {
    if (!(world.visited >> i & 1)) studs += hops_[i];
  }
  return ticksPerStud_ * studs;
}

// Of equal f the older cell.
uint64_t BeamChooser::rankOf(const Archive& archive, uint32_t cell) const {
  const uint64_t f =
      uint64_t(archive.tick(cell)) + left_[cell] + uint64_t(rounds_[cell]) * kTriedTicks;
  return f << 32 | cell;
}

void BeamChooser::rank(const Archive& archive, ThreadPool& pool, size_t width) {
  const uint32_t cells = archive.cellCount();
  blocks_.resize((cells + kBlock - 1) / kBlock);
  pool.run(int(blocks_.size()), [&](int task) {
    std::vector<uint64_t>& block = blocks_[size_t(task)];
    block.clear();
    const uint32_t first = uint32_t(task) * kBlock, last = std::min(first + kBlock, cells);
    for (uint32_t cell = first; cell < last; ++cell) block.push_back(rankOf(archive, cell));
    keepLeast(block, width);
  });
  ranked_.clear();
  for (const auto& block : blocks_) ranked_.insert(ranked_.end(), block.begin(), block.end());
  keepLeast(ranked_, width);
}

void BeamChooser::choose(const Archive& archive, ThreadPool& pool, Random&,
                         std::span<Choice> choices) {
  for (uint32_t cell = uint32_t(left_.size()); cell < archive.cellCount(); ++cell) {
    left_.push_back(uint32_t(kGreed * ticksLeft(archive.world(cell))));
  }
  rounds_.resize(archive.cellCount(), 0);
  rank(archive, pool, (choices.size() + kTries - 1) / kTries);
  for (size_t i = 0; i < choices.size(); ++i) {
    choices[i].cell = uint32_t(ranked_[i % ranked_.size()]);
  }
  for (const uint64_t r : ranked_) ++rounds_[uint32_t(r)];
}

std::unique_ptr<Chooser> makeBeamChooser(const Problem& problem, const ExploreContext&) {
  return std::make_unique<BeamChooser>(problem);
}

}  // namespace obby::solve
