#include "solve/archive.h"

#include <algorithm>

namespace obby::solve {

Archive::Archive(uint32_t maxCells, uint32_t looseCount)
    : looseCount_(looseCount), maxCells_(maxCells), slots_(4096, Slot{0, kNone}) {}

size_t Archive::slotOf(uint64_t key) const {
  const size_t mask = slots_.size() - 1;
  size_t slot = key & mask;
  while (slots_[slot].key != 0 && slots_[slot].key != key) slot = (slot + 1) & mask;
  return slot;
}

uint32_t Archive::find(uint64_t key) const { return slots_[slotOf(key)].cell; }

void Archive::growTable() {
  std::vector<Slot> old(slots_.size() * 2, Slot{0, kNone});
  old.swap(slots_);
  for (const Slot& s : old) {
    if (s.key != 0) slots_[slotOf(s.key)] = s;
  }
}

void Archive::addCell(size_t slot, uint64_t key, const sim::World& world) {
  slots_[slot] = {key, cellCount()};
  arrivals_.push_back({world.tick, world.jumps});
  worlds_.push_back(world);
  loose_.resize(loose_.size() + looseCount_);
  cellNodes_.push_back(kNone);
  seen_.push_back(0);
  sighted_.push_back(0);
  potentials_.push_back(0);
  if (size_t(cellCount()) * 2 > slots_.size()) growTable();
}

bool Archive::offer(uint64_t key, const sim::World& world, const Node& node, float potential,
                    const sim::LooseBody* loose) {
  const size_t slot = slotOf(key);
  uint32_t cell = slots_[slot].cell;
  if (cell == kNone) {
    if (cellCount() >= maxCells_) return false;
    cell = cellCount();
    addCell(slot, key, world);
  } else {
    // Found twice in one round, by two rollouts.
    if (nodes_[cellNodes_[cell]].rollout != node.rollout) sighted_[cell] = 1;
    if (!better(cell, world)) return false;
    arrivals_[cell] = {world.tick, world.jumps};
    worlds_[cell] = world;
  }
  if (looseCount_ != 0)
    std::copy_n(loose, looseCount_, loose_.begin() + std::ptrdiff_t(size_t(cell) * looseCount_));
  cellNodes_[cell] = uint32_t(nodes_.size());
  nodes_.push_back(node);
  potentials_[cell] = potential;
  bestPotential_ = std::max(bestPotential_, potential);
  return true;
}

uint64_t Archive::singletons() const {
  return uint64_t(std::count(sighted_.begin(), sighted_.end(), uint8_t(0)));
}

}  // namespace obby::solve
