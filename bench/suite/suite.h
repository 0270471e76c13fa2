// The query suite of levels/expected.tsv with its level and query records.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::bench {

struct SuiteQuery {
  std::string file, id;  // file: path below the folder of levels
  std::string expected;  // solved, unreachable or unsolved; the latter two have no solution
  io::Record level, query;
  uint64_t content;  // digest of all that can change a trajectory
  double effort;     // effort.h

  bool solvable() const { return expected == "solved"; }
  std::string name() const { return file + ":" + id; }
};

// Loads the suite of the folder `levels` in the table's order: all rows, or those named FILE:ID in
// `only`. Errors: a row without its query, an unknown name, a level that does not compile.
Result<std::vector<SuiteQuery>> loadSuite(const std::string& levels,
                                          const std::vector<std::string>& only);

}  // namespace obby::bench
