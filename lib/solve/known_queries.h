// The queries of a stream that later trajectories may name, for checking these. A stream need not
// end, so only the newest queries that fit are kept.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "base/result.h"
#include "io/record.h"
#include "solve/newest.h"

namespace obby::solve {

class KnownQueries {
 public:
  static constexpr uint64_t kMostBytes = uint64_t(256) << 20;

  // `mostBytes`: budget of the kept queries.
  explicit KnownQueries(uint64_t mostBytes) : queries_(mostBytes) {}

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

  Newest<Key, io::Record> queries_;
};

}  // namespace obby::solve
