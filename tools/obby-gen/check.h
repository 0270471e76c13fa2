// --check: verifies a generated level with the solver. Its budget counts steps, so that every
// machine keeps the same levels.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "io/record.h"
#include "solve/query_solver.h"

namespace obby::tools {

struct CheckOptions {
  bool wanted = false;
  bool unsolvable = false;  // keep levels proven unreachable instead of solved ones
  uint64_t steps = 0;
  uint64_t seed = 0;
  const std::atomic<bool>* stop = nullptr;
};

// Returns the answer's records if the level is kept, else nothing. It uses one thread, since levels
// are checked in parallel.
Result<std::optional<std::vector<io::RecordBuilder>>> checkLevel(const io::Record& level,
                                                                 schema::Query::Reader query,
                                                                 const CheckOptions& options);

}  // namespace obby::tools
