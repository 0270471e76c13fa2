// The best known value of each measure for each query of the suite, each from any solution.
#pragma once

#include <map>
#include <string>

#include "base/result.h"
#include "quality/measure.h"

namespace obby::bench {

class BestKnown {
 public:
  // Reads a table with a header line and tab-separated columns: query, ticks, jumps, turnsBack,
  // changes, length. A missing file is an empty table.
  static Result<BestKnown> read(const std::string& path);
  Status write(const std::string& path) const;

  // Keeps what is better than before.
  void note(const std::string& query, const Quality& quality);
  // The query must have been noted or read.
  const Quality& of(const std::string& query) const { return best_.at(query); }

 private:
  std::map<std::string, Quality> best_;
};

}  // namespace obby::bench
