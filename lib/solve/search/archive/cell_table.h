// Keys to cells: open addressing with slots of 8 bytes, so that ten million cells take 134 MB of
// table beside their keys. Host only.
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

  // The cell of a key, or level::kNone. Safe to call from several threads between changes.
  uint32_t find(uint64_t key) const;

  // Adds a key that is not there; cells are numbered as they come, from 0.
  void add(uint64_t key);

  uint32_t size() const { return uint32_t(keys_.size()); }

  // Ask the memory for what likely(key) will read.
  void prefetch(uint64_t key) const { __builtin_prefetch(&slots_[home(key)]); }
  // The cell that find(key) will look at first, or level::kNone. Its key has been asked for.
  uint32_t likely(uint64_t key) const;

 private:
  struct Slot {
    uint32_t tag = 0;              // the key's upper half; the lower says where to look
    uint32_t cell = level::kNone;  // free
  };
  static constexpr size_t kFirstSlots = 4096;

  static uint32_t tagOf(uint64_t key) { return uint32_t(key >> 32); }
  size_t home(uint64_t key) const { return key & (slots_.size() - 1); }
  size_t next(size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
  void place(uint64_t key, uint32_t cell);
  void grow();

  std::vector<Slot> slots_;       // at most three quarters full, a power of two
  ChunkedVector<uint64_t> keys_;  // (cells)
};

}  // namespace obby::solve
