// Answers one query: compiles it, searches, checks every solution with the verifier, and writes the
// answer as records. Progress comes first, then the trajectories, then the result.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "io/record.h"
#include "level/level.h"
#include "level/player.h"
#include "solve/answers/earlier_answers.h"
#include "solve/methods.h"
#include "solve/players/player_levels.h"

namespace obby::solve {

// A level of the stream, ready for queries.
struct LoadedLevel {
  io::Record record;
  level::Level level;
  double compileSeconds;
  // Levels of other players, shared by all queries of the level.
  std::unique_ptr<PlayerLevels> players = std::make_unique<PlayerLevels>();
};

Result<LoadedLevel> loadLevel(const io::Record& record);

struct SolverOptions {
  Budget budget;
  const Method* method = nullptr;
  const policy::Network* policy = nullptr;  // for methods that use one; may be null
  bool progressRecords = true;
  bool paths = false;    // trajectories include positions, for readers that cannot replay
  bool heatMap = false;  // results include a map of where the search went
  const EarlierAnswers* earlier = nullptr;  // tried first; may be null
  bool explain = false;  // find a change that makes a query solvable; takes up to as long again
  uint32_t difficultyTrials = 0;  // per segment of a solution; 0: difficulty is not asked for
};

// Progress of a query, to show to a person.
struct QueryProgress {
  std::string query;
  double fraction;  // of the budget
  uint64_t steps, cells;
  float closest;  // studs
};

struct SolverOutput {
  std::function<Status(schema::Record::Reader)> write;
  std::function<void(const QueryProgress&)> progress;  // may be empty
  std::function<void(const Error&)> deviceFailed;      // called if the device fails; may be empty
};

struct QueryAnswer {
  schema::Verdict verdict;
  Stopped stopped;
};

// One player's share of a query. Level and query are that player's, and the query names no players.
struct PlayerQuestion {
  const LoadedLevel& level;
  schema::Query::Reader query;
  level::Player player;
  uint32_t levelRate = 0;            // ticks per second of the original level; 0: that of `level`
  std::vector<KnownWay> hints = {};  // tried after earlier answers, and not reported as such
  std::vector<Companion> companions = {};               // other players who press the same keys
  std::function<bool(const Playthrough&)> accept = {};  // called for each solution; may be empty
  std::function<bool()> goOn = {};                      // false ends the search; may be empty
};

Result<QueryAnswer> solveFor(const PlayerQuestion& question, const SolverOptions& options,
                             const Machine& machine, const SolverOutput& output);

// Answers for every player that the query names, or for the level's own. An error is about the
// query record (path is set), or comes from `write`.
Result<QueryAnswer> solveQuery(const LoadedLevel& level, schema::Query::Reader query,
                               const SolverOptions& options, const Machine& machine,
                               const SolverOutput& output);

}  // namespace obby::solve
