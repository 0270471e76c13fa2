#include "solve/known_levels.h"

#include <fmt/format.h>

#include <utility>

namespace obby::solve {

void KnownLevels::weigh(const std::string& name) {
  const auto found = levels_.find(name);
  if (found == levels_.end()) return;
  const uint64_t bytes = bytesOf(*found->second.level);
  bytes_ += bytes - found->second.bytes;
  found->second.bytes = bytes;
}

std::vector<std::string> KnownLevels::add(LevelPointer level) {
  const std::string name = level->level.name();
  forget(name);
  const uint64_t bytes = bytesOf(*level);
  bytes_ += bytes;
  byAge_[added_] = name;
  levels_.insert_or_assign(name, Kept{std::move(level), bytes, added_});
  ++added_;
  std::vector<std::string> dropped;
  while (bytes_ > mostBytes_ && levels_.size() > 1) dropped.push_back(dropOldest());
  return dropped;
}

void KnownLevels::forget(const std::string& name) {
  const auto found = levels_.find(name);
  if (found == levels_.end()) return;
  bytes_ -= found->second.bytes;
  byAge_.erase(found->second.number);
  levels_.erase(found);
}

std::string KnownLevels::dropOldest() {
  std::string name = byAge_.begin()->second;
  forget(name);
  ++dropped_;
  return name;
}

Result<KnownLevels::LevelPointer> KnownLevels::named(const std::string& name) const {
  const auto found = levels_.find(name);
  if (!name.empty() && found != levels_.end()) return found->second.level;
  Error error{{}, {}, "level", "no level before this record", {}};
  if (!name.empty()) error.message = fmt::format("no level '{}' before this record", name);
  error.hint = "put a level record before its queries in the stream";
  if (name.empty() || dropped_ == 0) return error;
  // The names of dropped levels are not kept, since they would grow without bound.
  error.message += fmt::format(" is still in memory: the oldest {} were dropped", dropped_);
  error.hint = fmt::format(
      "put queries and trajectories right after their level; only the newest levels are kept, up "
      "to "
      "{} MiB",
      mostBytes_ >> 20);
  return error;
}

}  // namespace obby::solve
