// Asks one query once, as a user would who opens a level and waits for the answer.
#pragma once

#include <atomic>
#include <optional>

#include "base/thread_pool.h"
#include "solve/search/methods/methods.h"
#include "suite/run_log.h"
#include "suite/suite.h"

namespace obby::bench {

struct Question {
  const SuiteQuery& query;
  const solve::Method& method;
  uint64_t seed;
  double cap;  // seconds
};

// The run that a question stands for, not yet made.
Run plannedRun(const Question& question, uint64_t program);

// Makes the run: compiles the level, searches on all threads, checks the solution by a replay; all
// of that is in its seconds. Nothing if `stop` was set meanwhile.
Result<std::optional<Run>> ask(const Question& question, Run planned, ThreadPool& pool,
                               const std::atomic<bool>& stop);

}  // namespace obby::bench
