// Maps keys to cells by open addressing with slots of 8 bytes. Ten million cells take 134 MB of
// table plus their keys. Host only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/chunked_vector.h"
#include "level/level_view.h"

namespace obby::solve {

class CellTable {
 public:
  CellTable() : slots_(kFirstSlots) {}

  // Returns the cell of a key, or level::kNone. Thread-safe between changes.
  uint32_t find(uint64_t key) const;

  // Adds a key that is not in the table. Cells are numbered from 0 in the order in which they are
  // added.
  void add(uint64_t key);

  uint32_t size() const { return uint32_t(keys_.size()); }

  // Prefetches the slot that likely(key) reads.
  void prefetch(uint64_t key) const { __builtin_prefetch(&slots_[home(key)]); }
  // Returns the first cell that find(key) will compare, or level::kNone, and prefetches its key.
  uint32_t likely(uint64_t key) const;

 private:
  struct Slot {
    uint32_t tag = 0;              // upper half of the key; the lower half selects the slot
    uint32_t cell = level::kNone;  // kNone: the slot is free
  };
  static constexpr size_t kFirstSlots = 4096;

  static uint32_t tagOf(uint64_t key) { return uint32_t(key >> 32); }
  size_t home(uint64_t key) const { return key & (slots_.size() - 1); }
  size_t next(size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
  void place(uint64_t key, uint32_t cell);
  void grow();

  std::vector<Slot> slots_;       // at most three quarters full; the size is a power of two
  ChunkedVector<uint64_t> keys_;  // (cells)
};

}  // namespace obby::solve
