#include "solve/known_queries.h"

#include <fmt/format.h>

#include <utility>

#include "io/compact.h"

namespace obby::solve {
namespace {

constexpr uint64_t kBookkeeping = 512;  // bytes of maps and allocations per query

}  // namespace

uint64_t KnownQueries::bytesOf(const std::string& level, const io::Record& query) {
  const uint64_t names = level.size() + query.reader().getQuery().getId().size();
  return io::compactBytes(query) + 2 * names + kBookkeeping;
}

void KnownQueries::add(const std::string& level, const io::Record& query) {
  const std::string id = query.reader().getQuery().getId();
  Key key(level, id);
  if (const auto found = queries_.find(key); found != queries_.end()) forget(found);
  const uint64_t bytes = bytesOf(level, query);
  bytes_ += bytes;
  byAge_.emplace(added_, key);
  queries_.emplace(std::move(key), Kept{io::compact(query), bytes, added_});
  ++added_;
  while (bytes_ > mostBytes_ && queries_.size() > 1) {
    forget(queries_.find(byAge_.begin()->second));
    ++dropped_;
  }
}

void KnownQueries::forgetLevel(const std::string& level) {
  for (auto at = queries_.lower_bound(Key(level, std::string()));
       at != queries_.end() && at->first.first == level;) {
    forget(at++);
  }
}

void KnownQueries::forget(Queries::iterator query) {
  bytes_ -= query->second.bytes;
  byAge_.erase(query->second.number);
  queries_.erase(query);
}

Result<io::Record> KnownQueries::named(const std::string& level, const std::string& id) const {
  if (const auto found = queries_.find(Key(level, id)); found != queries_.end()) {
    return found->second.query;
  }
  Error error{{},
              {},
              "query",
              fmt::format("no query '{}' before this record", id),
              "put the query record before its trajectories in the stream"};
  if (dropped_ == 0) return error;
  // The ids of dropped queries are not kept, since they would grow without bound.
  error.message += fmt::format(" is still in memory: the oldest {} were dropped", dropped_);
  error.hint = fmt::format(
      "put trajectories right after their query; only the newest queries are kept, up to {} MiB",
      mostBytes_ >> 20);
  return error;
}

}  // namespace obby::solve
