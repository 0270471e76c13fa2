#include "solve/choose_beam.h"

#include <algorithm>

#include "solve/block_tasks.h"

namespace obby::solve {

namespace {

constexpr size_t kTries = 4;          // rollouts from a cell in a round
constexpr float kGreed = 5;           // more than 1: finds some way sooner, not the shortest
constexpr uint32_t kTriedTicks = 60;  // what a round's tries add to f: no cell waits for ever
constexpr uint32_t kTaken = 0xffffffffu;
constexpr uint64_t kNoRank = ~uint64_t(0);

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

void BeamChooser::addCells(const Archive& archive) {
  for (uint32_t cell = uint32_t(extra_.size()); cell < archive.cellCount(); ++cell) {
    extra_.push_back(uint32_t(kGreed * ticksLeft(archive.world(cell))));
  }
  blocks_.resize(archive.blockCount());
  groups_.resize(groupCount(archive));
}

// A rank is f, then the cell: of equal f the older is the best.
uint64_t BeamChooser::blockBest(const Archive& archive, uint32_t block) const {
  const uint32_t first = block * Archive::kBlock;
  const uint32_t count = std::min(Archive::kBlock, archive.cellCount() - first);
  const uint32_t* const ticks = archive.ticks().at(first);
  const uint32_t* const extra = extra_.at(first);
  uint64_t best = kNoRank;
  for (uint32_t i = 0; i < count; ++i) {
    const uint64_t rank = (uint64_t(ticks[i]) + extra[i]) << 32 | (first + i);
    best = std::min(best, extra[i] == kTaken ? kNoRank : rank);
  }
  return best;
}

uint64_t BeamChooser::groupBest(uint32_t group) const {
  const size_t first = size_t(group) * kGroupBlocks;
  const size_t end = std::min(first + kGroupBlocks, blocks_.size());
  uint64_t best = kNoRank;
  for (size_t block = first; block < end; ++block) best = std::min(best, blocks_[block]);
  return best;
}

void BeamChooser::update(const Archive& archive, ThreadPool& pool) {
  addCells(archive);
  forGroups(archive, pool, [&](uint32_t group, uint32_t first, uint32_t end) {
    for (uint32_t block = first; block < end; ++block) {
      if (archive.arrivedSince(block, epoch_)) blocks_[block] = blockBest(archive, block);
    }
    groups_[group] = groupBest(group);
  });
  epoch_ = archive.epoch();
}

void BeamChooser::rerank(const Archive& archive, uint32_t cell, uint32_t extra) {
  extra_[cell] = extra;
  const uint32_t block = cell / Archive::kBlock;
  blocks_[block] = blockBest(archive, block);
  groups_[block / kGroupBlocks] = groupBest(block / kGroupBlocks);
}

// Takes the best cell so often, then gives all of them back, tried once more.
void BeamChooser::rank(const Archive& archive, size_t width) {
  ranked_.clear();
  std::vector<uint32_t> extras;
  while (ranked_.size() < width) {
    const uint64_t best = *std::min_element(groups_.begin(), groups_.end());
    if (best == kNoRank) break;
    ranked_.push_back(best);
    extras.push_back(extra_[uint32_t(best)]);
    rerank(archive, uint32_t(best), kTaken);
  }
  for (size_t i = 0; i < ranked_.size(); ++i) {
    rerank(archive, uint32_t(ranked_[i]), extras[i] + kTriedTicks);
  }
}

void BeamChooser::choose(const Archive& archive, ThreadPool& pool, Random&,
                         std::span<Choice> choices) {
  update(archive, pool);
  rank(archive, (choices.size() + kTries - 1) / kTries);
  for (size_t i = 0; i < choices.size(); ++i) {
    choices[i].cell = uint32_t(ranked_[i % ranked_.size()]);
  }
}

std::unique_ptr<Chooser> makeBeamChooser(const Problem& problem, const ExploreContext&) {
  return std::make_unique<BeamChooser>(problem);
}

}  // namespace obby::solve
