// Generates the levels of obby-gen's output in order, on several threads.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/thread_pool.h"
#include "check.h"
#include "gen/generator.h"
#include "io/stream.h"

namespace obby::tools {

struct EmitOptions {
  uint64_t seed = 0, first = 0;
  uint64_t count = 1;                     // indices to keep; 0: endless
  io::Format format = io::Format::jsonl;  // encoding of the records
  CheckOptions check;
};

// A level of each generator, with its records. If --check refuses one of them, none is kept.
struct Emitted {
  std::vector<gen::Generated> levels;
  std::vector<io::Record> records;  // level, query and answer of each level
};

// Consecutive levels that --check may refuse before the run ends.
constexpr uint64_t kMaxRefused = 300;

enum class Ended { complete, stopped, noneKept };

struct Emission {
  Ended ended = Ended::stopped;
  uint64_t kept = 0, refused = 0;  // number of indices kept, and refused
};

// Calls `take` for each index in order, until `count` were kept or `stop` is set. Returns noneKept
// if --check refused too many in a row.
Result<Emission> emit(std::span<const gen::Generator> generators, const EmitOptions& options,
                      ThreadPool& pool, const std::atomic<bool>& stop,
                      const std::function<Status(const Emitted&)>& take);

}  // namespace obby::tools
