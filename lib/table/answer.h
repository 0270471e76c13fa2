// One query and its answer as a row of the table: facts taken from the records, in words for
// designers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "schema/obby.capnp.h"

namespace obby::table {

enum class State {
  notAsked,  // the stream has the query only
  noResult,  // and trajectories or progress
  solved,
  doubtful,  // solved, but it may not hold in the game
  unreachable,
  unknown,
  mismatch,  // a recorded solution does not replay
};

struct Answer {
  std::string query;     // id
  std::string level;     // name; shown where queries of several levels have one id
  std::string from, to;  // start and goal; empty: not known
  std::string route;     // both in words, instead of them; empty: there is none
  State state = State::notAsked;
  std::optional<double> playTime, foundIn;  // seconds
  std::optional<uint32_t> jumps;
  std::string reason;
};

// What rows need to know of a level.
struct LevelFacts {
  std::string name;
  double controlRate = 60;          // ticks per second
  std::vector<std::string> spawns;  // their names
};

LevelFacts factsOf(schema::Level::Reader level);

// Names where the query starts and ends. `level` may be null.
void describe(schema::Query::Reader query, const LevelFacts* level, Answer& answer);
// Fills in verdict, times, jumps and reason.
void describe(schema::Result::Reader result, double controlRate, Answer& answer);

}  // namespace obby::table
