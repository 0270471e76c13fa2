// The queries of a stream, for checking their trajectories, which come later. A stream need not
// end, so only the newest queries that fit are kept.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "base/result.h"
#include "io/record.h"
#include "solve/newest.h"

namespace obby::solve {

class QueryCache {
 public:
  static constexpr uint64_t kMaxBytes = uint64_t(256) << 20;

  // `maxBytes`: memory budget of the kept queries.
  explicit QueryCache(uint64_t maxBytes) : queries_(maxBytes) {}

  // Returns the approximate memory of a kept query and the name of its level, in bytes.
  static uint64_t bytesOf(const std::string& level, const io::Record& query);

  // Adds a copy of a query as the newest. It replaces a query with the same id and level.
  void add(const std::string& level, const io::Record& query);
  // Forgets all queries of a level.
  void forgetLevel(const std::string& level);

  // Returns the query with this id and level. Error at path "query": the query is not cached.
  Result<io::Record> named(const std::string& level, const std::string& id) const;

 private:
  using Key = std::pair<std::string, std::string>;  // level and id

  Newest<Key, io::Record> queries_;
};

}  // namespace obby::solve
