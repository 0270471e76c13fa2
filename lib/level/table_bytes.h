// How much memory a compiled level takes.
#pragma once

#include <cstddef>
#include <unordered_set>

#include "level/level_view.h"

namespace obby::level {

// Bytes of the tables of a level, about; what colliders or movers share counts once.
inline size_t tableBytes(LevelView view) {
  std::unordered_set<const void*> counted;
  size_t bytes = 0;
  const auto add = [&](const auto* table, size_t count) {
    if (table != nullptr && counted.insert(table).second) bytes += count * sizeof(*table);
  };
  forTables(view, add);
  for (uint32_t i = 0; i < view.colliderCount; ++i) {
    Collider collider = view.colliders[i];
    forTables(collider, add);
  }
  for (uint32_t i = 0; i < view.moverCount; ++i) {
    Mover mover = view.movers[i];
    forTables(mover, add);
  }
  return bytes;
}

}  // namespace obby::level
