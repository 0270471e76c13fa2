// One query and its answer as a row of the table. The facts come from the records, in words for
// designers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "schema/obby.capnp.h"

namespace obby::table {

enum class State {
  notAsked,  // the stream has only the query
  noResult,  // the stream has trajectories or progress, but no result
  solved,
  doubtful,  // solved, but the solution may fail in the game
  unreachable,
  unknown,
  mismatch,  // a recorded solution does not replay
};

struct Answer {
  std::string query;     // id
  std::string level;     // name of the level; shown if queries of several levels have the same id
  std::string from, to;  // start and goal; empty if unknown
  std::string route;     // start and goal in words, which replace `from` and `to`; may be empty
  State state = State::notAsked;
  std::optional<double> playTime, foundIn;  // seconds
  std::optional<uint32_t> jumps;
  std::string reason;
};

// The facts of a level that rows need.
struct LevelFacts {
  std::string name;
  double controlRate = 60;          // control steps per second
  std::vector<std::string> spawns;  // names of the spawns
};

LevelFacts factsOf(schema::Level::Reader level);

// Sets the names of the query's start and goal. `level` may be null.
void describe(schema::Query::Reader query, const LevelFacts* level, Answer& answer);
// Sets verdict, times, jumps and reason.
void describe(schema::Result::Reader result, double controlRate, Answer& answer);

}  // namespace obby::table
