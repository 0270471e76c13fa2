// Levels to learn on as a stream gives them, read as they are asked for: the stream may be endless.
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
#include "train/training_level.h"
#include "train/wait_limit.h"

namespace obby::train {

struct LevelStreamSettings {
  // Of records, kept to begin again with once the stream is at its end; of a longer stream the
  // first so many. A level counts once, however many queries it has.
  size_t keptBytes = size_t(256) << 20;
  // A query may be of any of so many levels before it, and of no more than have so many bytes as
  // records; of the last one always.
  size_t levelsInReach = 1024;
  size_t bytesInReach = size_t(1) << 30;
  bool again = true;  // at its end; otherwise there are no more levels, and none is kept
  // Of records that came to others first, as where the stream is a copy of another one.
  io::SourceSummary before = {};
  // Queries in a row whose difficulty is said and of which one is played at a time: as hard as
  // learning is ready for. 1: all are, one after the other.
  uint32_t choices = 4;
  // That wait to be asked for; others are compiled again then. Places get on at different speeds:
  // what is read for the foremost comes long before the turn of others, ever longer over days.
  size_t compiledLevels = 512;
  WaitLimit* wait = nullptr;  // for records, where there is one; must outlive the stream
};

// Levels behind a `params` record are played under it, as far as they leave the defaults.
//
// Queries that can be played come in turns: of so many to choose from in a row whose difficulty is
// said, any other alone. Level `index` is one of the index-th turn: by chance one of those that are
// not too hard, or where all are the easiest.
class LevelStream : public LevelSource {
 public:
  LevelStream(io::SourceOptions options, const LevelStreamSettings& settings = {});

  // Errors: those of the stream up to there, a query without a level, a level or query that does
  // not compile, as `options` forgive them; no query that can be played in the whole stream; where
  // it would begin again, an end that says it was interrupted, unless `options` forgive that. Waits
  // for the stream; null if `options.stop` was set before it came to the level, or if it ends
  // before and is not to begin again.
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override;
  // Does not wait for the stream, even while level() does.
  void past(uint64_t index) const override;
  // Ends settings.wait, if there is one.
  void end() const override;

  // Of what was read so far, and of settings.before. Waits for who reads.
  io::SourceSummary summary() const;

  // Levels that are compiled and wait to be asked for; all that were compiled when they were read:
  // what tests count.
  size_t compiledHeld() const;
  size_t compiledOnReading() const;

 private:
  using Playable = std::shared_ptr<const TrainingLevel>;
  struct Item {
    io::Record level, query;
    Playable compiled;  // null once its turn was asked for or is past, to be made again if need be

    // As the query says it, 0 to 1; -1: it does not.
    float difficulty() const { return query.reader().getQuery().getDifficulty(); }
  };
  using Turn = std::vector<Item>;
  static std::string nameOf(const std::vector<std::string>& inputs);
  static const Item& chosen(const Turn& turn, uint64_t index, float hardest);
  static size_t compiledOf(const Turn& turn);

  struct Known {  // a level that queries may be of
    std::string name;
    io::Record record;
    size_t bytes;
    bool counted;  // among what is kept
  };

  struct Reader {  // all of it under the lock
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
    std::string inputName;          // as errors say it
    io::RecordSource source;
    LevelStreamSettings settings;
    io::Physics physics;
    std::deque<Known> levels;  // the last ones, oldest first
    size_t reach = 0;          // their bytes
    std::map<uint64_t, Turn> turns;
    Turn open;            // the next one: it may get more
    uint64_t read = 0;    // turns so far
    uint64_t kept = 0;    // the first so many stay
    uint64_t needed = 0;  // those before will not be asked for, unless the stream begins again
    size_t bytes = 0;     // of what is kept
    size_t waiting = 0;   // compiled levels of the turns
    bool full = false;    // no more of them
    size_t compiledOnReading = 0;
    bool ended = false;
    Status said;  // an error ends it
  };

  mutable std::atomic<uint64_t> past_{0};  // the reader hears of it as soon as it can
  mutable std::mutex lock_;
  mutable Reader reader_;
};

}  // namespace obby::train
