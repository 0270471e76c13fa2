// Training levels from a stream, read on demand. The stream may be endless.
#pragma once

#include <atomic>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "io/physics.h"
#include "io/pipeline.h"
#include "train/timeout.h"
#include "train/training_level.h"

namespace obby::train {

struct LevelStreamSettings {
  // Max bytes of records kept to restart the stream after its end: the first ones of a longer
  // stream. A level counts once, however many queries it has.
  size_t keptBytes = size_t(256) << 20;
  // Max number and bytes of recent levels that a query may refer to. It may always refer to the
  // last one.
  size_t levelsInReach = 1024;
  size_t bytesInReach = size_t(1) << 30;
  bool again = true;  // restart at the stream's end; if false, levels end there and none are kept
  // If the stream is a copy, the summary of the records read to make the copy.
  io::SourceSummary before = {};
  // Number of consecutive queries with a difficulty from which one is chosen by the current
  // difficulty. 1: each is played, in order.
  uint32_t choices = 4;
  // Max compiled levels that wait for their turn; others are recompiled. Places advance at
  // different speeds, so levels read for the fastest place wait ever longer for the others.
  size_t compiledLevels = 512;
  Timeout* timeout = nullptr;  // time limit for records, or null; must outlive the stream
};

// Levels after a `params` record get its parameters where they leave the defaults.
//
// Queries form turns: up to `choices` consecutive queries with a difficulty, or a single one
// without. Level `index` is from the index-th turn: a random query that is not too hard, or else
// one of the easiest.
class LevelStream : public LevelSource {
 public:
  LevelStream(io::SourceOptions options, const LevelStreamSettings& settings = {});

  // Waits for the stream. Returns null if `options.stop` is set first, or if the stream ends first
  // and does not restart. Errors: those of the stream up to that level; a query without a level; a
  // level or query that does not compile, unless `options` forgive it; no playable query in the
  // whole stream; an interrupted end before a restart, unless `options` forgive it.
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override;
  // Does not wait for the stream, even while level() waits.
  void past(uint64_t index) const override;
  // Ends settings.timeout, if there is one.
  void end() const override;

  // Returns the summary of all records so far, with settings.before. Waits for a running read.
  io::SourceSummary summary() const;

  // For tests. Both return a number: of compiled levels that wait, and of levels compiled on
  // reading.
  size_t compiledHeld() const;
  size_t compiledOnReading() const;

 private:
  using Playable = std::shared_ptr<const TrainingLevel>;
  struct Item {
    io::Record level, query;
    Playable compiled;  // null after its turn; recompiled on demand

    // Returns the query's difficulty, 0 to 1; -1 if it has none.
    float difficulty() const { return query.reader().getQuery().getDifficulty(); }
  };
  using Turn = std::vector<Item>;
  static std::string nameOf(const std::vector<std::string>& inputs);
  static const Item& chosen(const Turn& turn, uint64_t index, float hardest);
  static size_t compiledOf(const Turn& turn);

  struct Known {  // a level that queries may refer to
    std::string name;
    io::Record record;
    size_t bytes;
    bool counted;  // included in the kept bytes
  };

  struct Reader {  // guarded by the lock
    Reader(io::SourceOptions options, const LevelStreamSettings& s)
        : stop(options.stop),
          inputName(nameOf(options.inputs)),
          source(std::move(options)),
          settings(s) {}

    Status readTo(uint64_t index);
    Status readOne();
    bool stopped() const { return stop != nullptr && *stop; }
    Status take(const io::Record& record);
    Status takeQuery(const io::Record& record);
    bool passedOver(const io::Record& query) const;
    void add(Item item, size_t recordBytes);
    void close();
    void know(const io::Record& level);
    Known* levelNamed(const std::string& name);
    void forget(uint64_t before);
    void played(uint64_t number, Turn& turn, const Item& item);
    void dropCompiled(Turn& turn);

    const std::atomic<bool>* stop;  // may be null
    std::string inputName;          // input name for errors
    io::RecordSource source;
    LevelStreamSettings settings;
    io::Physics physics;
    std::deque<Known> levels;  // recent levels, oldest first
    size_t reach = 0;          // size of `levels`, bytes
    std::map<uint64_t, Turn> turns;
    Turn open;            // the turn that is being filled
    uint64_t read = 0;    // turns so far
    uint64_t kept = 0;    // number of turns kept for a restart, from the first on
    uint64_t needed = 0;  // first turn still needed; earlier turns are needed only after a restart
    size_t bytes = 0;     // size of the kept records
    size_t waiting = 0;   // compiled levels of the turns
    bool full = false;    // no more turns are kept
    size_t compiledOnReading = 0;
    bool ended = false;
    Status said;  // the error that ended reading
  };

  mutable std::atomic<uint64_t> past_{0};  // passed to the reader when the lock is free
  mutable std::mutex lock_;
  mutable Reader reader_;
};

}  // namespace obby::train
