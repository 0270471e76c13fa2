// Trajectories of an earlier answer stream, which are tried again before a search. After most edits
// of a level an old solution still works, or most of it leads to a new one.
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
  // Reads the trajectories of a stream and skips everything else. Error: the stream cannot be read,
  // or a trajectory is invalid.
  static Result<EarlierAnswers> read(io::SourceOptions source);

  Status note(schema::Trajectory::Reader trajectory);

  // The player for whom trajectories are wanted, and rates in ticks per second.
  struct For {
    level::Player player;
    uint32_t rate, levelRate;  // rates of the player and of the level
  };

  // Returns the trajectories of this player, then those of others, all retimed to the player's
  // rate. Both keep the order of the stream: solutions first. Returns an empty list if there are
  // none.
  std::vector<ActionRuns> trajectoriesOf(const std::string& level, const std::string& query,
                                         const For& who) const;
  // Forgets the trajectories of a query, before new ones are noted.
  void forget(const std::string& level, const std::string& query);

 private:
  struct PlayerTrajectory {
    level::Player player;
    ActionRuns runs;
  };

  std::map<std::pair<std::string, std::string>, std::vector<PlayerTrajectory>> trajectories_;
};

}  // namespace obby::solve
