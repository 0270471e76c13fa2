// The queries of a stream that later trajectories may name, for checking these. A stream need not
// end, so only the newest queries that fit are kept.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "base/result.h"
#include "io/record.h"

namespace obby::solve {

class KnownQueries {
 public:
  static constexpr uint64_t kMostBytes = uint64_t(256) << 20;

  // `mostBytes`: budget of the kept queries. The newest is kept whatever its size.
  explicit KnownQueries(uint64_t mostBytes) : mostBytes_(mostBytes) {}

  // Returns the approximate memory of a kept query and the name of its level, in bytes.
  static uint64_t bytesOf(const std::string& level, const io::Record& query);

  // Keeps a copy of a query as the newest, in place of an older one of its id and level.
  void add(const std::string& level, const io::Record& query);
  // Forgets all queries of a level.
  void forgetLevel(const std::string& level);

  // Returns the query of an id and level. Error, with path "query": none of that id and level is
  // kept.
  Result<io::Record> named(const std::string& level, const std::string& id) const;

 private:
  using Key = std::pair<std::string, std::string>;  // level and id
  struct Kept {
    io::Record query;
    uint64_t bytes, number;
  };
  using Queries = std::map<Key, Kept>;

  void forget(Queries::iterator query);

  const uint64_t mostBytes_;
  Queries queries_;
  std::map<uint64_t, Key> byAge_;     // oldest first
  uint64_t bytes_ = 0;                // of all kept queries
  uint64_t added_ = 0, dropped_ = 0;  // so far
};

}  // namespace obby::solve
