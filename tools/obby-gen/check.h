// --check: is a generated level what it was meant to be? By the solver, within a budget of steps,
// so that the same levels are kept on every machine.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "io/record.h"
#include "solve/query_solver.h"

namespace obby::tools {

struct CheckOptions {
  bool wanted = false;
  bool unsolvable = false;  // keep what is unreachable in place of what is solved
  uint64_t steps = 0;
  uint64_t seed = 0;
  const std::atomic<bool>* stop = nullptr;
};

// The answer's records, if the level is to be kept. One thread each: levels are checked side by
// side.
Result<std::optional<std::vector<io::RecordBuilder>>> checkLevel(const io::Record& level,
                                                                 schema::Query::Reader query,
                                                                 const CheckOptions& options);

}  // namespace obby::tools
