// Replays trajectories of players other than the level's own. They are played under their player's
// physics and converted to the level's ticks, in which everything is shown.
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

// Converts a playback from `from` to `to` ticks per second. Positions are interpolated linearly,
// and events move to the next tick.
Playback resampled(Playback playback, uint32_t from, uint32_t to);

class PlayerReplays {
 public:
  struct Replayed {
    Playback playback;
    // The trajectory in the level's ticks; absent if the record is in these ticks already.
    std::optional<io::Record> record;
  };

  // `query` belongs to `level`, whose index in the report is `index`.
  Result<Replayed> play(const LevelEntry& level, int index, const QueryEntry& query,
                        schema::Trajectory::Reader record);

 private:
  Result<const level::Level*> levelFor(const LevelEntry& level, int index,
                                       const level::Player& player);

  std::map<std::pair<int, level::Player>, std::unique_ptr<const level::Level>> levels_;
};

}  // namespace obby::view
