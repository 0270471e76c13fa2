// Everything that a report shows, gathered from streams: levels, queries, results, and trajectories
// with their replay.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
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
  io::Record record;  // a trajectory, or the progress that holds some
  Playback playback;
  uint32_t death = 0;  // of an attempt in a progress: which of them

  schema::Trajectory::Reader reader() const;
};

// A query that the streams name, be it by its own record or by an answer to it.
struct QueryEntry {
  std::string id;
  int level = -1;  // index into Report::levels; -1: not in the streams
  std::optional<io::Record> query;
  std::shared_ptr<const level::Query> compiled;  // set if `query` and the level are
  std::optional<io::Record> result;
  std::vector<PathEntry> paths;  // solutions first

  schema::Query::Reader reader() const { return query->reader().getQuery(); }
  schema::Result::Reader answer() const { return result->reader().getResult(); }
  bool mismatch() const;  // a recorded solution does not replay
};

struct Report {
  std::vector<LevelEntry> levels;
  std::vector<QueryEntry> queries;
  std::vector<std::string> notes;  // for people: what is missing and why

  std::string title() const;
};

// Takes the records of a stream in order, in one pass; answers may come before their query.
class Collector {
 public:
  // Decides about a record that cannot be shown: success goes on without it.
  using Forgive = std::function<Status(const io::Record&, Error)>;
  explicit Collector(Forgive forgive) : forgive_(std::move(forgive)) {}

  Status add(const io::Record& record);
  // Compiles queries and replays trajectories. The collector is used up. Where `only` is not empty,
  // other queries are left out; an id that is not there is an error.
  Result<Report> finish(const std::vector<std::string>& only = {});

 private:
  Status addLevel(const io::Record& record);
  void addProgress(const io::Record& record);
  // The level of a query or an answer: by name, or the last one; -1 where there is none.
  int levelNamed(const std::string& name) const;
  QueryEntry& queryNamed(const std::string& id, int level);
  Status select(const std::vector<std::string>& only);
  Status compile(QueryEntry& entry);
  Status replay(QueryEntry& entry);

  Forgive forgive_;
  Report report_;
  std::map<std::pair<int, std::string>, size_t> byName_;
};

}  // namespace obby::view
