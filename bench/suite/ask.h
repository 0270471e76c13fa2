// Answers one query once, like a user who opens a level and waits for the answer.
#pragma once

#include <atomic>
#include <optional>

#include "base/thread_pool.h"
#include "solve/methods.h"
#include "suite/run_log.h"
#include "suite/suite.h"

namespace obby::bench {

struct Trial {
  const SuiteQuery& query;
  const solve::Method& method;
  uint64_t seed;
  double cap;  // seconds
};

// Returns the run of a trial, without its result.
Run plannedRun(const Trial& trial, uint64_t program);

// Makes the run: compiles the level, searches on all threads, and verifies the solution by a
// replay. Its seconds include all of these. Returns nothing if `stop` was set meanwhile.
Result<std::optional<Run>> ask(const Trial& trial, Run planned, ThreadPool& pool,
                               const std::atomic<bool>& stop);

}  // namespace obby::bench
