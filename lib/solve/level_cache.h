// The levels of a stream that its queries and trajectories may name. A stream need not end, so only
// the newest levels that fit are kept.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "solve/answer/loaded_level.h"
#include "solve/newest.h"

namespace obby::solve {

class LevelCache {
 public:
  using LevelPointer = std::shared_ptr<const LoadedLevel>;

  static constexpr uint64_t kMaxBytes = uint64_t(1) << 30;

  // `maxBytes`: memory budget of the kept levels, both records and compiled.
  explicit LevelCache(uint64_t maxBytes) : levels_(maxBytes) {}

  // Adds a level as the newest. It replaces a level with the same name. Returns the names of the
  // levels dropped to make space, oldest first.
  std::vector<std::string> add(LevelPointer level);
  // Updates the memory of a level after it was compiled for more players.
  void weigh(const std::string& name);
  // Forgets the level with this name, if it is cached.
  void forget(const std::string& name) { levels_.forget(name); }

  // Returns the level with this name. Error at path "level": the name is empty, or no level with
  // this name is cached.
  Result<LevelPointer> named(const std::string& name) const;

 private:
  Newest<std::string, LevelPointer> levels_;  // by name
};

}  // namespace obby::solve
