// A query for one of its players, and the answer.
#pragma once

#include <optional>
#include <vector>

#include "solve/answer/solver_options.h"

namespace obby::solve {

struct PlayerCase {
  level::Player player;
  const LoadedLevel* level;  // the level compiled for the player
  io::Record query;          // in ticks of `level`, without players
  uint32_t rate;             // ticks per second of that level

  // Filled in once the case is answered.
  std::optional<io::Record> result;
  std::vector<io::Record> solutions, attempts;  // trajectories
  Stopped stopped = Stopped::outOfTime;

  schema::Query::Reader queryRecord() const { return query.reader().getQuery(); }
  schema::Result::Reader answer() const { return result->reader().getResult(); }
};

// Returns the unanswered cases of a query's players. They are valid while `level` lives.
Result<std::vector<PlayerCase>> playerCases(const LoadedLevel& level, schema::Query::Reader query);

// Returns the unanswered case of one player.
Result<PlayerCase> playerCase(const LoadedLevel& level, schema::Query::Reader query,
                              const level::Player& player);

}  // namespace obby::solve
