// The contents of a report, collected from streams: levels, queries, results, and replayed
// trajectories.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/record.h"
#include "level/level.h"
#include "view/entries.h"
#include "view/player_replay.h"
#include "view/replay.h"

namespace obby::view {

// Limits on what a collector keeps of a stream.
struct PageBudget {
  // Max ticks of all replays, some 15 bytes each; part events count as well.
  size_t ticks = 20'000'000;
  size_t trajectoryTicks = 0;  // fixed cost of a trajectory in ticks, for its record and numbers
  // Cost of each run of equal actions in ticks. A run takes some 50 bytes in the input's line,
  // 8 in the record and 8 in a page.
  size_t runTicks = 0;
  // Budget for later levels, queries and answers; records beyond it are dropped.
  size_t bytes = SIZE_MAX;
  // True if newer trajectories evict the oldest ones, attempts before solutions. Otherwise attempts
  // over the budget are left out, and solutions over it are errors.
  bool rolls = false;
};

// Takes the records of a stream in order, in one pass. Answers may come before their query. The
// report may be read between records.
class Collector {
 public:
  // Decides about a record that cannot be shown. On success the collector continues without it.
  using Forgive = std::function<Status(const io::Record&, Error)>;
  // If `only` is not empty, queries that it does not name, and their records, are left out. A note
  // reports records over the limits.
  explicit Collector(Forgive forgive, std::vector<std::string> only = {}, PageBudget budget = {})
      : forgive_(std::move(forgive)), only_(std::move(only)), budget_(budget) {}

  Status add(const io::Record& record);
  // Compiles queries and replays trajectories that came since the last call. Failures are left out,
  // whatever `forgive` returns. Returns the first error that `forgive` did not accept.
  Status update();
  // Returns the report as of the last update().
  const Report& report() const { return report_; }
  // Adds a sentence for the report's users.
  void note(std::string text) { report_.notes.push_back(std::move(text)); }
  // Error: no record has an id of `only`.
  Status checkChosen() const;
  // Moves the report out, in the state of the last update(). The collector is used up.
  Report take() { return std::move(report_); }

 private:
  Status addLevel(const io::Record& record);
  void addQuery(const io::Record& record);
  void addProgress(const io::Record& record);
  void addFirstSolution(QueryEntry& entry, const io::Record& record);
  void addAttempts(QueryEntry& entry, const io::Record& record);
  void addPath(QueryEntry& entry, PathEntry path);
  bool wanted(const io::Record& record) const;
  // Returns the level that a query or an answer names. If several have that name, prefers the
  // current one, then the latest new one. An empty name is the current level. Returns -1 for an
  // unknown level.
  int levelNamed(const std::string& name) const;
  QueryEntry& queryNamed(const std::string& id, int level);
  Status compile(QueryEntry& entry);
  Status replay(QueryEntry& entry);
  Status play(const QueryEntry& entry, PathEntry& path);

  // eviction.cpp
  size_t costOf(const PathEntry& path, const Playback& playback) const;
  void keep(PathEntry& path, Playback playback);
  void forget(PathEntry& path);
  bool fits(size_t cost) const { return ticksKept_ + cost <= budget_.ticks; }
  void evictFor(size_t cost, PathKind kind);
  void dropOldest(size_t cost, PathKind kind);
  void sweepDropped();
  void weigh(QueryEntry& entry);
  void weigh(const LevelEntry& entry);
  bool full();

  PlayerReplays players_;
  Forgive forgive_;
  std::vector<std::string> only_;
  PageBudget budget_;
  size_t ticksKept_ = 0, bytesKept_ = 0;
  // Notes given: omitted attempts, dropped records, and cut part events.
  bool attemptsNoted_ = false, fullNoted_ = false, cutNoted_ = false;
  size_t dropped_ = 0;                 // number of dropped trajectories
  std::optional<size_t> droppedNote_;  // index of the note about the number of dropped trajectories
  std::set<size_t> thinned_;           // queries with dropped trajectories
  Report report_;
  int current_ = -1;  // index of the latest level record; -1: none that can be shown
  std::map<std::pair<std::string, uint64_t>, int> levels_;  // by name and hash
  std::map<std::string, int> lastNamed_;                    // latest level of a name
  std::map<std::pair<int, std::string>, size_t> byName_;
  std::set<size_t> touched_;  // queries changed since the last update
  uint64_t serial_ = 0;
};

}  // namespace obby::view
