// The inputs and outputs of the solver for one query.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solve/answer/earlier_answers.h"
#include "solve/answer/loaded_level.h"
#include "solve/improve/preference.h"
#include "solve/search/method.h"

namespace obby::solve {

struct SolverOptions {
  Budget budget;
  const Method* method = nullptr;
  const policy::Network* policy = nullptr;  // for methods that use one; may be null
  bool progressRecords = true;
  bool paths = false;    // trajectories include positions, for readers that cannot replay
  bool heatMap = false;  // results include a map of where the search went
  const EarlierAnswers* earlier = nullptr;  // tried first; may be null
  bool explain = false;  // look for a change that makes a query solvable; may double the time
  const Preference* preference = nullptr;  // improve solutions by it; null: keep those found first
  uint64_t improveSteps = 0;               // budget for that, simulated ticks per query
  uint32_t difficultyTrials = 0;           // trials per segment; 0: no difficulty
};

// Progress of a query, to show to a person.
struct QueryProgress {
  std::string query;
  double fraction;  // spent share of the budget
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
  uint32_t levelRate = 0;              // ticks per second of the original level; 0: that of `level`
  std::vector<ActionRuns> hints = {};  // tried after the earlier answers, but not counted with them
  std::vector<Companion> companions = {};              // other players who press the same keys
  std::function<bool(const Trajectory&)> accept = {};  // called for each solution; may be empty
  std::function<bool()> goOn = {};                     // false ends the search; may be empty
};

}  // namespace obby::solve
