// The query suite: what levels/expected.tsv lists, with the level and query records, ready to be
// asked.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::bench {

struct SuiteQuery {
  std::string file, id;  // file: below the folder of levels
  std::string expected;  // solved, unreachable, unsolved: either way of having no solution
  io::Record level, query;
  uint64_t content;  // digest of both, as far as they can change a playthrough
  double effort;     // effort.h

  bool solvable() const { return expected == "solved"; }
  std::string name() const { return file + ":" + id; }
};

// The suite of the folder `levels`, in the order of its table: all, or those named FILE:ID in
// `only`. Errors: a row without its query, a name that is in no row, a level that does
// not compile.
Result<std::vector<SuiteQuery>> loadSuite(const std::string& levels,
                                          const std::vector<std::string>& only);

}  // namespace obby::bench
