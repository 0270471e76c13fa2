// The levels of a stream that its queries and trajectories may name. A stream need not end, so the
// newest are kept, as many as fit.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "solve/loaded_level.h"

namespace obby::solve {

class KnownLevels {
 public:
  using LevelPointer = std::shared_ptr<const LoadedLevel>;

  static constexpr uint64_t kMostBytes = uint64_t(1) << 30;

  // `mostBytes`: what the kept levels may take together, as records and compiled. The newest is
  // kept whatever it takes.
  explicit KnownLevels(uint64_t mostBytes) : mostBytes_(mostBytes) {}

  // Keeps a level as the newest, in place of an older one of its name. Gives the names of those
  // that are dropped for it, the oldest first.
  std::vector<std::string> add(LevelPointer level);
  // Counts again what a level takes: it has been compiled for more players.
  void weigh(const std::string& name);
  // As if none of that name had come.
  void forget(const std::string& name);

  // Error, with path "level": none of that name is kept. An empty name names none.
  Result<LevelPointer> named(const std::string& name) const;

 private:
  struct Kept {
    LevelPointer level;
    uint64_t bytes, number;
  };

  std::string dropOldest();

  const uint64_t mostBytes_;
  std::map<std::string, Kept> levels_;     // by name
  std::map<uint64_t, std::string> byAge_;  // their names, the oldest first
  uint64_t bytes_ = 0;                     // of all that are kept
  uint64_t added_ = 0, dropped_ = 0;       // so far
};

}  // namespace obby::solve
