// Trajectories of other players than the level's own: played in the level as the player meets it,
// and told in the level's ticks, as all that is shown.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "io/record.h"
#include "level/player.h"
#include "view/replay.h"

namespace obby::view {

struct QueryEntry;
struct LevelEntry;

// A playthrough in `to` ticks per second instead of `from`: places between two ticks are on the
// straight line, and what happens, happens at the next tick.
Playback retold(Playback playback, uint32_t from, uint32_t to);

class PlayerReplays {
 public:
  struct Told {
    Playback playback;
    // The trajectory in the level's ticks; none: the record is.
    std::optional<io::Record> record;
  };

  // `query` is of this level, the `index`th.
  Result<Told> play(const LevelEntry& level, int index, const QueryEntry& query,
                    schema::Trajectory::Reader record);

 private:
  Result<const level::Level*> levelFor(const LevelEntry& level, int index,
                                       const level::Player& player);

  std::map<std::pair<int, level::Player>, std::unique_ptr<const level::Level>> levels_;
};

}  // namespace obby::view
