#include "solve/known_levels.h"

#include <fmt/format.h>

#include <utility>

namespace obby::solve {

std::vector<std::string> KnownLevels::add(LevelPointer level) {
  const std::string name = level->level.name();
  forget(name);
  const uint64_t words = level->record.reader().totalSize().wordCount;
  words_ += words;
  byAge_[added_] = name;
  levels_.insert_or_assign(name, Kept{std::move(level), words, added_});
  ++added_;
  std::vector<std::string> dropped;
  while (words_ > mostWords_ && levels_.size() > 1) dropped.push_back(dropOldest());
  return dropped;
}

void KnownLevels::forget(const std::string& name) {
  const auto found = levels_.find(name);
  if (found == levels_.end()) return;
  words_ -= found->second.words;
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
  error.hint = "a level record comes before its queries in the stream";
  if (name.empty() || dropped_ == 0) return error;
  // Their names are not kept, for they too would come without end.
  error.message += fmt::format(" that is still kept: the oldest {} were dropped", dropped_);
  error.hint = fmt::format(
      "put queries and trajectories right behind their level; the newest levels are kept, {} MiB "
      "of records",
      mostWords_ >> 17);
  return error;
}

}  // namespace obby::solve
