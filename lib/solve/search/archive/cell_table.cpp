#include "solve/search/archive/cell_table.h"

namespace obby::solve {

uint32_t CellTable::find(uint64_t key) const {
  const uint32_t tag = tagOf(key);
  for (size_t slot = home(key);; slot = next(slot)) {
    const Slot& s = slots_[slot];
    if (s.cell == level::kNone || (s.tag == tag && keys_[s.cell] == key)) return s.cell;
  }
}

uint32_t CellTable::likely(uint64_t key) const {
  const uint32_t tag = tagOf(key);
  for (size_t slot = home(key);; slot = next(slot)) {
    const Slot& s = slots_[slot];
    if (s.cell == level::kNone) return level::kNone;
    if (s.tag != tag) continue;
    __builtin_prefetch(keys_.at(s.cell));
    return s.cell;
  }
}

void CellTable::place(uint64_t key, uint32_t cell) {
  size_t slot = home(key);
  while (slots_[slot].cell != level::kNone) slot = next(slot);
  slots_[slot] = {tagOf(key), cell};
}

void CellTable::add(uint64_t key) {
  keys_.push_back(key);
  if (keys_.size() * 4 > slots_.size() * 3) {
    grow();
  } else {
    place(key, size() - 1);
  }
}

// The keys alone determine the slots, so the new table does not need the old one.
void CellTable::grow() {
  const size_t slots = 2 * slots_.size();
  slots_ = {};  // frees the old table before the new one is allocated
  slots_.resize(slots);
  uint32_t cell = 0;
  for (size_t c = 0; c < keys_.chunkCount(); ++c) {
    for (const uint64_t key : keys_.chunk(c)) place(key, cell++);
  }
}

}  // namespace obby::solve
