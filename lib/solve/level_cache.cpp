#include "solve/level_cache.h"

#include <fmt/format.h>

#include <utility>

namespace obby::solve {

void LevelCache::weigh(const std::string& name) {
  if (const LevelPointer* level = levels_.find(name)) levels_.weigh(name, bytesOf(**level));
}

std::vector<std::string> LevelCache::add(LevelPointer level) {
  const uint64_t bytes = bytesOf(*level);
  const std::string name = level->level.name();
  return levels_.add(name, std::move(level), bytes);
}

Result<LevelCache::LevelPointer> LevelCache::named(const std::string& name) const {
  const LevelPointer* found = levels_.find(name);
  if (!name.empty() && found) return *found;
  Error error{{}, {}, "level", "there is no level before this record", {}};
  if (!name.empty()) error.message = fmt::format("there is no level '{}' before this record", name);
  error.hint = "put a level record before its queries in the stream";
  if (name.empty()) return error;
  return levels_.explained(std::move(error), "put queries and trajectories right after their level",
                           "levels");
}

}  // namespace obby::solve
