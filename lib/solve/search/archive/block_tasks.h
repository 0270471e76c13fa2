// Refreshes the selectors' data about the archive's blocks, in groups of blocks on the pool's
// threads. Host only.
#pragma once

#include <cstdint>

#include "base/thread_pool.h"
#include "solve/search/archive/archive.h"

namespace obby::solve {

constexpr uint32_t kGroupBlocks = 64;  // blocks per group
constexpr uint32_t kTaskGroups = 4;    // groups per task of the pool

inline uint32_t groupCount(const Archive& archive) {
  return (archive.blockCount() + kGroupBlocks - 1) / kGroupBlocks;
}

// Calls refresh(group, firstBlock, endBlock) for every group of the archive's blocks.
template <class Refresh>
void forGroups(const Archive& archive, ThreadPool& pool, Refresh&& refresh) {
  const uint32_t blocks = archive.blockCount(), groups = groupCount(archive);
  pool.run(int((groups + kTaskGroups - 1) / kTaskGroups), [&](int task) {
    const uint32_t first = uint32_t(task) * kTaskGroups;
    for (uint32_t g = first; g < std::min(first + kTaskGroups, groups); ++g) {
      refresh(g, g * kGroupBlocks, std::min((g + 1) * kGroupBlocks, blocks));
    }
  });
}

}  // namespace obby::solve
