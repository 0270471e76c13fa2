#include "emit.h"

#include <algorithm>

namespace obby::tools {

namespace {

constexpr uint64_t kTaskLevels = 32;    // levels per task
constexpr uint64_t kLevelWords = 4096;  // initial capacity, enough for most levels

using Slot = Result<std::optional<Emitted>>;

// Returns false if --check refuses the level.
Result<bool> add(const gen::Generator& generator, const EmitOptions& options, uint64_t index,
                 Emitted& out) {
  out.levels.push_back(generator.generate(options.seed, index));
  io::RecordBuilder level(kLevelWords), query;
  generator.writeLevel(out.levels.back(), level.root().initLevel());
  gen::Generator::writeQuery(out.levels.back(), query.root().initQuery());
  OBBY_ASSIGN(const io::Record levelRecord, io::encoded(std::move(level), options.format));
  OBBY_ASSIGN(const io::Record queryRecord, io::encoded(std::move(query), options.format));
  out.records.push_back(levelRecord);
  out.records.push_back(queryRecord);
  if (!options.check.wanted) return true;
  CheckOptions check = options.check;
  check.unsolvable = generator.unsolvable();
  OBBY_ASSIGN(auto answer, checkLevel(levelRecord, queryRecord.reader().getQuery(), check));
  if (!answer) return false;
  for (io::RecordBuilder& record : *answer) {
    OBBY_ASSIGN(const io::Record done, io::encoded(std::move(record), options.format));
    out.records.push_back(done);
  }
  return true;
}

Slot make(std::span<const gen::Generator> generators, const EmitOptions& options, uint64_t index) {
  Emitted out;
  for (const gen::Generator& generator : generators) {
    OBBY_ASSIGN(const bool kept, add(generator, options, index, out));
    if (!kept) return std::optional<Emitted>();
  }
  return std::optional(std::move(out));
}

// Generates levels from `begin` on, in order.
std::vector<Slot> makeBatch(std::span<const gen::Generator> generators, const EmitOptions& options,
                            ThreadPool& pool, const std::atomic<bool>& stop, uint64_t begin,
                            uint64_t count) {
  std::vector<Slot> slots(count, Slot(std::optional<Emitted>()));
  const uint64_t each = options.check.wanted ? 1 : kTaskLevels;
  pool.run(int((count + each - 1) / each), [&](int task) {
    const uint64_t from = uint64_t(task) * each;
    for (uint64_t i = from; i < std::min(from + each, count) && !stop; ++i) {
      slots[i] = make(generators, options, begin + i);
    }
  });
  return slots;
}

}  // namespace

Result<Emission> emit(std::span<const gen::Generator> generators, const EmitOptions& options,
                      ThreadPool& pool, const std::atomic<bool>& stop,
                      const std::function<Status(const Emitted&)>& take) {
  const uint64_t each = options.check.wanted ? 2 : kTaskLevels;
  const uint64_t batch = each * uint64_t(pool.size());
  Emission out;
  uint64_t inARow = 0;
  for (uint64_t begin = options.first; !stop; begin += batch) {
    const uint64_t left = options.count == 0 ? batch : options.count - out.kept;
    const uint64_t size = options.check.wanted ? batch : std::min(batch, left);
    std::vector<Slot> slots = makeBatch(generators, options, pool, stop, begin, size);
    if (stop) break;  // incomplete batches are not written
    for (Slot& slot : slots) {
      if (!slot) return slot.error();
      if (!*slot) {
        ++out.refused;
        if (++inARow < kMaxRefused) continue;
        out.ended = Ended::noneKept;
        return out;
      }
      inARow = 0;
      OBBY_RETURN_IF_ERROR(take(**slot));
      if (++out.kept < options.count || options.count == 0) continue;
      out.ended = Ended::complete;
      return out;
    }
  }
  return out;
}

}  // namespace obby::tools
