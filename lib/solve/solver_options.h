// What the solver is asked for a query, and where its answer goes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solve/earlier_answers.h"
#include "solve/loaded_level.h"
#include "solve/search/methods/methods.h"

namespace obby::solve {

struct SolverOptions {
  Budget budget;
  const Method* method = nullptr;
  const policy::Network* policy = nullptr;  // for methods that use one; null: they do without
  bool progressRecords = true;
  bool paths = false;    // trajectories say where the player is, for readers that cannot replay
  bool heatMap = false;  // results have a map of where the search went
  const EarlierAnswers* earlier = nullptr;  // to be tried first; may be null
  bool explain = false;  // say what change would make a query solvable; up to as long again
  uint32_t difficultyTrials = 0;  // a segment of a solution; 0: not asked how hard it is
};

// For the eyes of a person while a query is worked on.
struct QueryProgress {
  std::string query;
  double fraction;  // of the budget
  uint64_t steps, cells;
  float closest;  // studs
};

struct SolverOutput {
  std::function<Status(schema::Record::Reader)> write;
  std::function<void(const QueryProgress&)> progress;  // may be empty
  std::function<void(const Error&)> deviceFailed;      // the CPU went on; may be empty
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
  uint32_t levelRate = 0;            // ticks per second of the level as it is; 0: those of `level`
  std::vector<KnownWay> hints = {};  // tried after earlier answers, and not told as such
  std::vector<Companion> companions = {};               // who press the same keys
  std::function<bool(const Playthrough&)> accept = {};  // asked of each solution; may be empty
  std::function<bool()> goOn = {};                      // false ends the search; may be empty
};

}  // namespace obby::solve
