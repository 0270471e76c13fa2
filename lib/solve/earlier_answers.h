// Playthroughs of an earlier answer stream, to be tried again before a search: after most edits of
// a level an old solution still works, or its greater part leads to a new one.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/pipeline.h"
#include "level/player.h"
#include "solve/model/problem.h"

namespace obby::solve {

class EarlierAnswers {
 public:
  // Reads the trajectories of a stream; everything else in it is skipped. Error: it cannot be read,
  // or a trajectory has no sense.
  static Result<EarlierAnswers> read(io::SourceOptions source);

  Status note(schema::Trajectory::Reader trajectory);

  // The player that the trajectories are for, and rates in ticks per second.
  struct For {
    level::Player player;
    uint32_t rate, levelRate;  // the player's, and the level's own
  };

  // Those of this player come first, then those of others, at this rate; both in the order of the
  // stream: solutions first. Empty: none.
  std::vector<KnownWay> waysOf(const std::string& level, const std::string& query,
                               const For& who) const;
  // Forgets those of a query: new ones are about to come.
  void forget(const std::string& level, const std::string& query);

 private:
  struct PlayersWay {
    level::Player player;
    KnownWay way;
  };

  std::map<std::pair<std::string, std::string>, std::vector<PlayersWay>> ways_;
};

}  // namespace obby::solve
