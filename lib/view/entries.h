// The entries of a report: levels, queries, and trajectories with their replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/record.h"
#include "level/level.h"
#include "view/replay.h"

namespace obby::view {

struct LevelEntry {
  io::Record record;
  std::shared_ptr<const level::Level> level;

  schema::Level::Reader reader() const { return record.reader().getLevel(); }
};

enum class PathKind { solution, attempt, closest, newest };

struct PathEntry {
  PathKind kind;
  io::Record record;  // a trajectory, or the progress that contains it
  Playback playback;
  uint32_t death = 0;    // index into the deaths of a progress record, for its attempts
  uint64_t serial = 0;   // unique within a collector, from 1 on
  bool dropped = false;  // evicted for newer ones; erased in the next update

  // The trajectory in the level's ticks, if the player's frame rate differs; else absent.
  std::optional<io::Record> resampled = {};

  bool played() const { return !playback.feet.empty(); }
  bool ofProgress() const { return record.which() == io::Kind::PROGRESS; }
  // True for the first solution of a search that still improves it.
  bool provisional() const { return kind == PathKind::solution && ofProgress(); }
  schema::Trajectory::Reader reader() const;
  // Returns the trajectory in the level's ticks.
  schema::Trajectory::Reader inLevelTicks() const {
    return resampled ? resampled->reader().getTrajectory() : reader();
  }
};

// A query named by its own record or by an answer to it.
struct QueryEntry {
  std::string id;
  int level = -1;  // index into Report::levels; -1: not in the streams
  std::optional<io::Record> query;
  std::shared_ptr<const level::Query> compiled;  // set if `query` and the level are known
  std::optional<io::Record> result;
  std::optional<io::Record> progress;  // the latest
  std::vector<PathEntry> paths;        // solutions first
  size_t bytes = 0;                    // size of the three records above, as the collector counts
                                       // it
  bool weighed = false;                // `bytes` is up to date

  schema::Query::Reader reader() const { return query->reader().getQuery(); }
  schema::Result::Reader answer() const { return result->reader().getResult(); }
  bool mismatch() const;  // a recorded solution does not replay
};

struct Report {
  std::vector<LevelEntry> levels;
  std::vector<QueryEntry> queries;
  std::vector<std::string> notes;  // sentences for users about what is missing and why

  std::string title() const;
  bool empty() const { return levels.empty() && queries.empty(); }
};

}  // namespace obby::view
