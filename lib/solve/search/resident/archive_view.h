// The archive of a search that lives on a device, as flat arrays for kernels. Only the slot of a
// key in the table depends on the order of the threads.
#pragma once

#include "sim/rigid_body.h"
#include "sim/world.h"
#include "solve/search/archive/archive_node.h"
#include "solve/search/resident/atomics.h"

namespace obby::solve {

struct CellSlot {
  uint64_t key;  // 0: free
  uint32_t cell;
};

struct ArchiveView {
  CellSlot* slots;         // (slotMask + 1), at most half full
  sim::World* worlds;      // (cells)
  sim::RigidBody* bodies;  // (cells, bodyCount)
  uint64_t* ranks;         // (cells), arrival ranks of the worlds
  uint32_t* nodes;         // (cells)
  uint32_t* seen;          // (cells)
  uint32_t* sighted;       // (cells), a bit each: a rollout other than the finder passed through
  uint32_t* waits;         // (cells), the beam's f less the ticks so far
  float* potentials;       // (cells)
  uint32_t slotMask, bodyCount, cellCount;
};

// Returns the cell of a key, or level::kNone. Must not run while cells are added.
OBBY_DEVICE uint32_t cellOf(const ArchiveView& a, uint64_t key) {
  for (uint32_t s = uint32_t(key) & a.slotMask;; s = (s + 1) & a.slotMask) {
    const CellSlot& slot = a.slots[s];
    if (slot.key == key) return slot.cell;
    if (slot.key == 0) return level::kNone;
  }
}

// Adds a key that no other thread adds.
OBBY_DEVICE void addKey(const ArchiveView& a, uint64_t key, uint32_t cell) {
  uint32_t s = uint32_t(key) & a.slotMask;
  while (compareExchange(&a.slots[s].key, 0, key) != 0) s = (s + 1) & a.slotMask;
  a.slots[s].cell = cell;
}

// Marks a cell as sighted. Returns true if it was not marked before.
OBBY_DEVICE bool noteSighted(const ArchiveView& a, uint32_t cell) {
  uint32_t* const word = a.sighted + cell / 32;
  const uint32_t bit = 1u << cell % 32;
  if (loadRelaxed(word) & bit) return false;
  return (fetchOr(word, bit) & bit) == 0;
}

}  // namespace obby::solve
