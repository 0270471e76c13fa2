// The solver as a filter over a stream: remembers levels and queries, answers queries behind their
// records, checks trajectories where only that is asked.
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
#include "solve/known_levels.h"
#include "solve/known_queries.h"
#include "solve/model/build_query.h"
#include "solve/pass_filter.h"
#include "solve/players/ask_players.h"
#include "solve/query_solver.h"

namespace obby::solve {

// What is done with a stream's queries and trajectories.
enum class Task {
  answer,  // the queries
  verify,  // check the trajectories
  filter,  // drop trajectories that `passes` does not keep
};

struct FilterOptions {
  Task task = Task::answer;
  SolverOptions solver;
  std::shared_ptr<const policy::PolicyFile> policy;  // what `solver` points to, if it was read
  EarlierAnswers earlier;                            // of the same queries
  bool remember = false;                             // keep the answers, for takeEarlier()
  int threads = 1;
  sim::Device* device = nullptr;    // for the rollouts; must outlive the filter; null: the threads
  std::vector<std::string> only;    // ids of the queries to answer; empty: all
  std::optional<QuickQuery> quick;  // asked of every level instead of the stream's queries
  bool each = false;                // `quick` changes the stream's queries instead
  AskedPlayers players;             // in place of every query's own, whoever asks it
  PassRule passes;
  uint64_t levelBytes = KnownLevels::kMostBytes;   // of the levels that are kept, as of KnownLevels
  uint64_t queryBytes = KnownQueries::kMostBytes;  // of the queries that are kept, where they are
  std::function<void(const QueryProgress&)> progress;  // may be empty
  std::function<void(const Error&)> deviceFailed;      // the CPU went on; may be empty
  // After each answer; may be empty.
  std::function<void(const std::string& level, const std::string& query, schema::Verdict)> answered;
};

struct FilterCounts {
  uint64_t solved = 0, unreachable = 0, unknown = 0;
  uint64_t verified = 0;  // trajectories that were right
  uint64_t kept = 0, dropped = 0;
};

class Filter {
 public:
  // Records go out through `pipeline`.
  Filter(FilterOptions options, io::Pipeline& pipeline);

  // The pipeline's handler.
  Result<io::Then> handle(const io::Record& record);
  // After the last record, unless the input was stopped before: a level without queries is asked
  // for the way from its spawn to its end; one that `quick` cannot be asked of for lack of a goal
  // and an id of `only` that was not met are errors.
  Status finishInput();

  const FilterCounts& counts() const { return counts_; }
  // What a next run can begin with: of each query the new answer, else the one before.
  EarlierAnswers takeEarlier() { return std::move(options_.earlier); }

 private:
  using LevelPointer = KnownLevels::LevelPointer;

  // The level record before.
  struct Last {
    LevelPointer level;
    io::Record read;       // as it came: has the place that errors about it name
    bool asked = false;    // by `quick`, or for the way to its end
    uint64_t queries = 0;  // of it that followed
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
  // With the boxes of the parts that it names, and the changes of `quick`.
  Result<io::Record> resolved(const LoadedLevel& level, const io::Record& query) const;
  bool asksQuick() const;
  bool wanted(const std::string& id) const;
  void note(const std::string& id);  // that the stream has a query of that name
  Status remember(schema::Trajectory::Reader trajectory, bool first);

  FilterOptions options_;
  io::Pipeline& pipeline_;
  ThreadPool pool_;
  io::Physics physics_;
  KnownLevels levels_;
  std::map<std::string, PassFilter> passFilters_;  // by level
  std::optional<Last> last_;
  KnownQueries queries_;                   // of the levels that are kept, under Task::verify
  std::vector<std::string> met_, others_;  // ids of `only` that came by; the first other ids
  FilterCounts counts_;
};

}  // namespace obby::solve
