#include "solve/query_cache.h"

#include <fmt/format.h>

#include <utility>

#include "io/compact.h"

namespace obby::solve {
namespace {

constexpr uint64_t kBookkeeping = 512;  // bytes of maps and allocations per query

}  // namespace

uint64_t QueryCache::bytesOf(const std::string& level, const io::Record& query) {
  const uint64_t names = level.size() + query.reader().getQuery().getId().size();
  return io::compactBytes(query) + 2 * names + kBookkeeping;
}

void QueryCache::add(const std::string& level, const io::Record& query) {
  const std::string id = query.reader().getQuery().getId();
  queries_.add({level, id}, io::compact(query), bytesOf(level, query));
}

void QueryCache::forgetLevel(const std::string& level) {
  queries_.forgetFrom({level, std::string()}, [&](const Key& key) { return key.first == level; });
}

Result<io::Record> QueryCache::named(const std::string& level, const std::string& id) const {
  if (const io::Record* found = queries_.find({level, id})) return *found;
  Error error{{},
              {},
              "query",
              fmt::format("there is no query '{}' before this record", id),
              "put the query record before its trajectories in the stream"};
  return queries_.explained(std::move(error), "put trajectories right after their query",
                            "queries");
}

}  // namespace obby::solve
