// The solver as a filter over a stream. It remembers levels and queries and answers queries after
// their records, or it checks or filters trajectories.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/physics.h"
#include "io/pipeline.h"
#include "policy/policy_file.h"
#include "solve/level_cache.h"
#include "solve/model/build_query.h"
#include "solve/pass_filter.h"
#include "solve/players/ask_players.h"
#include "solve/query_cache.h"
#include "solve/query_solver.h"

namespace obby::solve {

// The filter's task for the queries and trajectories of a stream.
enum class Task {
  answer,  // answer the queries
  verify,  // check the trajectories
  filter,  // drop trajectories that `passes` does not keep
};

struct FilterOptions {
  Task task = Task::answer;
  SolverOptions solver;
  std::shared_ptr<const policy::PolicyFile> policy;  // owner of solver.policy, if it was read
  EarlierAnswers earlier;                            // earlier answers to the same queries
  bool remember = false;                             // keep the answers for takeEarlier()
  int threads = 1;
  sim::Device* device = nullptr;    // runs the rollouts; must outlive the filter; null: threads
  std::vector<std::string> only;    // ids of the queries to answer; empty: all
  std::optional<QuickQuery> quick;  // asked of every level instead of the stream's queries
  bool each = false;                // `quick` changes the stream's queries instead
  AskedPlayers players;             // replace the players of every query
  PassRule passes;
  uint64_t levelBytes = LevelCache::kMaxBytes;         // limit of LevelCache
  uint64_t queryBytes = QueryCache::kMaxBytes;         // limit of QueryCache
  std::function<void(const QueryProgress&)> progress;  // may be empty
  std::function<void(const Error&)> deviceFailed;      // called if the device fails; may be empty
  // Called after each answer; may be empty.
  std::function<void(const std::string& level, const std::string& query, schema::Verdict)> answered;
};

struct FilterCounts {
  uint64_t solved = 0, unreachable = 0, unknown = 0;
  uint64_t verified = 0;  // trajectories that passed the check
  uint64_t kept = 0, dropped = 0;
};

class Filter {
 public:
  // Writes records to `pipeline`.
  Filter(FilterOptions options, io::Pipeline& pipeline);

  // Handles a record of the pipeline.
  Result<io::Then> handle(const io::Record& record);
  // Must be called after the last record, unless the input was stopped before. If the last level
  // has no queries, asks for a solution from its spawn to its end. Error: `quick` lacks a goal in
  // the level, or the stream has no query with an id of `only`.
  Status finishInput();

  const FilterCounts& counts() const { return counts_; }
  // Returns the answers from which a next run can start: each query's new answer, or its earlier
  // one.
  EarlierAnswers takeEarlier() { return std::move(options_.earlier); }

 private:
  using LevelPointer = LevelCache::LevelPointer;

  // The last level record.
  struct Last {
    LevelPointer level;
    io::Record read;       // as read; errors name its place in the input
    bool asked = false;    // true once `quick` or the default query was asked
    uint64_t queries = 0;  // number of its queries so far
  };

  Result<io::Then> handleLevel(const io::Record& read);
  Result<io::Then> take(const io::Record& played, const io::Record& read);
  Result<io::Then> handleQuery(const io::Record& record);
  Result<io::Then> handleTrajectory(schema::Trajectory::Reader trajectory);
  Status check(schema::Trajectory::Reader trajectory);
  Result<bool> keeps(schema::Trajectory::Reader trajectory);
  Status finishLevel();
  Status askDefault();
  Status ask(const LoadedLevel& level, const io::Record& query);
  Status answer(const LoadedLevel& level, schema::Query::Reader query);
  Result<LevelPointer> levelNamed(const std::string& name) const;
  void know(const LevelPointer& level);
  // Returns the query with the boxes of the parts that it names, and the changes of `quick`.
  Result<io::Record> resolved(const LoadedLevel& level, const io::Record& query) const;
  bool asksQuick() const;
  bool wanted(const std::string& id) const;
  void note(const std::string& id);  // notes that the stream has a query of this id
  Status remember(schema::Trajectory::Reader trajectory, bool first);

  FilterOptions options_;
  io::Pipeline& pipeline_;
  ThreadPool pool_;
  io::Physics physics_;
  LevelCache levels_;
  std::map<std::string, PassFilter> passFilters_;  // by level name
  std::optional<Last> last_;
  QueryCache queries_;                     // queries of cached levels, for Task::verify
  std::vector<std::string> met_, others_;  // ids of `only` that were met; the first few other ids
  FilterCounts counts_;
};

}  // namespace obby::solve
