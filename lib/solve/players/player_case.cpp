#include "solve/players/player_case.h"

namespace obby::solve {

Result<PlayerCase> playerCase(const LoadedLevel& level, schema::Query::Reader query,
                              const level::Player& player) {
  OBBY_ASSIGN(const LoadedLevel* const played, level.players->of(level, player));
  const uint16_t own = level.level.view().params.controlRate;
  const uint16_t rate = played->level.view().params.controlRate;
  io::RecordBuilder copy;
  copy.root().setQuery(query);
  level::setRate(own, rate, copy.root().getQuery());
  return PlayerCase{player, played, io::Record(std::move(copy)), rate, {}, {}, {}};
}

Result<std::vector<PlayerCase>> playerCases(const LoadedLevel& level, schema::Query::Reader query) {
  OBBY_ASSIGN(const std::vector<level::Player> players, level::playersOf(query));
  std::vector<PlayerCase> cases;
  for (const level::Player& player : players) {
    OBBY_ASSIGN(PlayerCase made, playerCase(level, query, player));
    cases.push_back(std::move(made));
  }
  return cases;
}

}  // namespace obby::solve
