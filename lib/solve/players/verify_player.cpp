#include "solve/players/verify_player.h"

#include <fmt/format.h>

#include "solve/players/player_text.h"
#include "solve/players/same_keys.h"
#include "solve/verify/verifier.h"

namespace obby::solve {

namespace {

Status checkKeys(const LoadedLevel& level, schema::Query::Reader query, const level::Player& player,
                 schema::Trajectory::Reader trajectory) {
  OBBY_ASSIGN(const std::vector<PlayerCase> cases, playerCases(level, query));
  const PlayerCase& first = cases[slowest(cases)];
  if (player != first.player) return {};
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(trajectory));
  for (const PlayerCase& c : cases) {
    if (&c == &first) continue;
    OBBY_ASSIGN(const KeyPlayer other, KeyPlayer::make(c));
    if (other.solve(plan.actions, first.rate)) continue;
    const PlayerVerdict who{c.player.body, c.rate, schema::Verdict::UNKNOWN};
    return Error{
        {},
        {},
        "actions",
        fmt::format("the same key presses do not reach the goal with {}", playerText(who, true)),
        {}};
  }
  return {};
}

}  // namespace

Status verifyPlayer(const LoadedLevel& level, schema::Query::Reader query,
                    schema::Trajectory::Reader trajectory) {
  OBBY_ASSIGN(const level::Player player, level::playerOf(trajectory));
  OBBY_ASSIGN(const PlayerCase c, playerCase(level, query, player));
  OBBY_RETURN_IF_ERROR(
      verify(c.level->level, c.level->record.reader().getLevel(), c.queryRecord(), trajectory));
  const bool solves = trajectory.getOutcome() == schema::Outcome::GOAL;
  return solves && query.getSameKeys() ? checkKeys(level, query, player, trajectory) : Status();
}

}  // namespace obby::solve
