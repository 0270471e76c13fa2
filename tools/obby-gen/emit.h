// Levels in order, made by several threads: what obby-gen writes.
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
  uint64_t count = 1;                     // indices to keep; 0: without end
  io::Format format = io::Format::jsonl;  // that records are encoded for
  CheckOptions check;
};

// A level, or one of each generator, with all that is written of it; nothing is kept of levels of
// which --check refuses one.
struct Emitted {
  std::vector<gen::Generated> levels;
  std::vector<io::Record> records;  // of each level, query, answer
};

// Levels in a row that --check may refuse before it gives up.
constexpr uint64_t kMostRefused = 300;

enum class Ended { complete, stopped, noneKept };

struct Emission {
  Ended ended = Ended::stopped;
  uint64_t kept = 0, refused = 0;  // indices; refused by --check
};

// Calls `take` for each index in order, until `count` were kept or `stop` is set. noneKept: --check
// refused so many in a row that more are not to be expected.
Result<Emission> emit(std::span<const gen::Generator> generators, const EmitOptions& options,
                      ThreadPool& pool, const std::atomic<bool>& stop,
                      const std::function<Status(const Emitted&)>& take);

}  // namespace obby::tools
