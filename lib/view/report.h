// Everything that a report shows, gathered from streams: levels, queries, results, and trajectories
// with their replay.
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

// How much of a stream a collector keeps.
struct Room {
  size_t ticks = 20'000'000;  // of replays, some 15 bytes each; what parts do counts, too
  size_t wayTicks = 0;        // for which each way counts beyond its own: its record, its numbers
  // Likewise each run of its actions: some 50 bytes of the line that it came as, 8 of its record, 8
  // of a page.
  size_t runTicks = 0;
  // Of levels but the first, queries and answers. Once it is passed, nothing more is taken in.
  size_t bytes = SIZE_MAX;
  // The oldest ways leave for newer ones, attempts before solutions. Else attempts for which there
  // are no ticks are left out, and such solutions are errors.
  bool rolls = false;
};

// Takes the records of a stream in order, in one pass; answers may come before their query. What is
// there may be looked at on the way.
class Collector {
 public:
  // Decides about a record that cannot be shown: success goes on without it.
  using Forgive = std::function<Status(const io::Record&, Error)>;
  // Where `only` is not empty, other queries and what belongs to them are left out. What there is
  // no room for is told in a note.
  explicit Collector(Forgive forgive, std::vector<std::string> only = {}, Room room = {})
      : forgive_(std::move(forgive)), only_(std::move(only)), room_(room) {}

  Status add(const io::Record& record);
  // Compiles queries and replays trajectories that came since the last time. What cannot be is left
  // out, whatever `forgive` says; the error is the first that it did not forgive.
  Status update();
  // As of the last update().
  const Report& report() const { return report_; }
  // A sentence for the report's readers.
  void note(std::string text) { report_.notes.push_back(std::move(text)); }
  // Error: no record named an id of `only`.
  Status checkChosen() const;
  // Hands it over, as of the last update(). The collector is used up.
  Report take() { return std::move(report_); }

 private:
  Status addLevel(const io::Record& record);
  void addQuery(const io::Record& record);
  void addProgress(const io::Record& record);
  void addPath(QueryEntry& entry, PathEntry path);
  bool wanted(const io::Record& record) const;
  // The level of a query or an answer: by name, of several the one before it in the stream or else
  // the last that was new; without a name the one before it. -1 where there is none.
  int levelNamed(const std::string& name) const;
  QueryEntry& queryNamed(const std::string& id, int level);
  Status compile(QueryEntry& entry);
  Status replay(QueryEntry& entry);
  Status play(const QueryEntry& entry, PathEntry& path);

  // room.cpp
  size_t costOf(const PathEntry& path, const Playback& playback) const;
  void keep(PathEntry& path, Playback playback);
  void forget(PathEntry& path);
  bool hasRoom(size_t cost) const { return ticksKept_ + cost <= room_.ticks; }
  void makeRoom(size_t cost, PathKind kind);
  void dropOldest(size_t cost, PathKind kind);
  void sweepDropped();
  void weigh(QueryEntry& entry);
  void weigh(const LevelEntry& entry);
  bool full();

  PlayerReplays players_;
  Forgive forgive_;
  std::vector<std::string> only_;
  Room room_;
  size_t ticksKept_ = 0, bytesKept_ = 0;
  // Noted: attempts were left out; records were; what parts do is cut.
  bool attemptsNoted_ = false, fullNoted_ = false, cutNoted_ = false;
  size_t dropped_ = 0;                 // ways
  std::optional<size_t> droppedNote_;  // place among the notes of the one that tells how many
  std::set<size_t> thinned_;           // queries that hold ways that were dropped
  Report report_;
  int current_ = -1;  // index into its levels: of the last level record; -1: none that can be shown
  std::map<std::pair<std::string, uint64_t>, int> levels_;  // by name and hash
  std::map<std::string, int> lastNamed_;                    // of the levels of a name the last
  std::map<std::pair<int, std::string>, size_t> byName_;
  std::set<size_t> touched_;  // queries that came or got something since the last update
  uint64_t serial_ = 0;
};

}  // namespace obby::view
