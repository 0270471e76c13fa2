#include "solve/search/archive/archive.h"

#include <cstring>

namespace obby::solve {

Archive::Archive(uint32_t maxCells, uint32_t bodyCount)
    : bodyCount_(bodyCount), maxCells_(maxCells) {}

void Archive::addCell(uint64_t key) {
  const uint32_t cell = cellCount();
  table_.add(key);
  ticks_.push_back(0);
  jumps_.push_back(0);
  worlds_.push_back({});
  if (bodyCount_ != 0) bodySets_.push_back(0);
  cellNodes_.push_back(kNone);
  seen_.push_back(0);
  sighted_.push_back(0);
  potentials_.push_back(0);
  if (cell % kBlock != 0) return;
  seenIn_.push_back(epoch_);
  arrivedIn_.push_back(epoch_);
}

bool Archive::offer(uint64_t key, const sim::World& world, const Node& node, float potential,
                    const sim::RigidBody* bodies) {
  uint32_t cell = find(key);
  if (cell == kNone) {
    if (cellCount() >= maxCells_) return false;
    cell = cellCount();
    addCell(key);
  } else {
    // Another rollout found the cell in the same round.
    if (nodes_[cellNodes_[cell]].rollout != node.rollout) sighted_[cell] = 1;
    if (!better(cell, world)) return false;
  }
  ticks_[cell] = world.tick;
  jumps_[cell] = world.jumps;
  worlds_[cell] = world;
  if (bodyCount_ != 0) putBodies(cell, bodies);
  cellNodes_[cell] = uint32_t(nodes_.size());
  nodes_.push_back(node);
  potentials_[cell] = potential;
  bestPotential_ = std::max(bestPotential_, potential);
  note(arrivedIn_, cell);
  return true;
}

bool Archive::isFirstBody(const sim::RigidBody* bodies) const {
  return bodySetCount_ > 0 &&
         std::memcmp(bodies, bodies_.at(0), bodyCount_ * sizeof(sim::RigidBody)) == 0;
}

// Several cells may share the first set; every other set belongs to one cell.
void Archive::putBodies(uint32_t cell, const sim::RigidBody* bodies) {
  uint32_t& set = bodySets_[cell];
  if (isFirstBody(bodies)) {
    set = 0;
    return;
  }
  if (set == 0) {
    set = bodySetCount_++;
    bodies_.resize(placeOfSet(set) + bodyCount_);
  }
  std::copy_n(bodies, bodyCount_, bodies_.at(placeOfSet(set)));
}

uint64_t Archive::singletons() const {
  uint64_t count = 0;
  for (size_t c = 0; c < sighted_.chunkCount(); ++c) {
    count += uint64_t(std::ranges::count(sighted_.chunk(c), uint8_t(0)));
  }
  return count;
}

}  // namespace obby::solve
