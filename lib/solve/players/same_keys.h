// One solution for several players: the same keys, held by time.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solve/players/player_case.h"
#include "solve/verify/posed_query.h"

namespace obby::solve {

// Returns the slowest player's index. The other players can change keys at each frame of the
// slowest, or soon after.
size_t slowest(const std::vector<PlayerCase>& cases);

// Returns the keys of each player's first solution, converted to the rate. Skips players without
// one.
std::vector<ActionRuns> firstKeys(std::span<const PlayerCase> cases, uint32_t rate);

// Plays another player's keys, and holds the last of them for up to a second more. solve() returns
// nothing if they do not solve the query.
class KeyPlayer {
 public:
  // The case must outlive this object.
  static Result<KeyPlayer> make(const PlayerCase& c);

  std::optional<Trajectory> solve(const ActionRuns& keys, uint32_t rate) const;
  PosedQuery posed() const;
  Companion companion() const;
  const PlayerCase& playerCase() const { return *case_; }

 private:
  KeyPlayer(const PlayerCase& c, level::Query query) : case_(&c), query_(std::move(query)) {}

  const PlayerCase* case_;
  level::Query query_;
};

}  // namespace obby::solve
