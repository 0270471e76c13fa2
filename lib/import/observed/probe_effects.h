// The effects of one touch or use, on the player and on parts.
#pragma once

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/report.h"
#include "import/draft.h"

namespace obby::importer {

struct Harmful {
  double damage = 0, cooldown = 0;
  bool lasts = false;      // it goes on once the player has left: the damage is that of one touch
  bool stoppable = false;  // a force field stops it
  engine::Line line;
};
struct Push {
  Vec3 velocity;
  bool keepsSideways = false;
  engine::Line line;
  double seconds = 0;  // that a mover holds the velocity; 0: it is set once
};
struct Teleported {
  Vec3 feet;
  bool turns = false;
  float yaw = 0;
  engine::Line line;
};
struct Booster {
  float walk = 1, jump = 1, gravity = 1;  // times what it was; below 0: the player floats up
  double seconds = 0;                     // after the player has left; 0: at once
  bool forever = false;
  bool resets = false;  // sets what it was, and nothing else
  engine::Line line;
};
// Progress that scripts keep of the player.
struct StageSet {
  std::optional<int> number;         // in leaderstats or the like
  std::optional<int64_t> team;       // the colour of the player's new team
  InstanceId respawn = kNoInstance;  // the SpawnLocation where the player comes back from now on
  engine::Line line;
};
// A number of the player that scripts keep under a name that does not tell its meaning.
struct UnnamedStat {
  int number = 0;
  engine::Line line;
};
struct Away {
  InstanceId part = kNoInstance;
  double delay = 0;
  std::optional<double> seconds;  // nothing: it did not come back
  engine::Line line;
  bool held = false;  // it came back as the player left: `seconds` after that
};
struct Moved {
  InstanceId part = kNoInstance;
  std::vector<Pose> poses;          // a frame each, from the touch on
  InstanceId driver = kNoInstance;  // the constraint or mover that moves it
  engine::Line line;
  std::optional<Motion> outlasting;  // by tweens that play at the probe's end
};

// A part that changes, and the line that changes it.
struct Changed {
  InstanceId part = kNoInstance;
  engine::Line line;
};

struct ProbeEffects {
  std::optional<Harmful> harm;
  std::optional<Push> push;
  std::optional<Teleported> teleport;
  std::optional<Booster> boost;
  std::optional<StageSet> stage;
  std::optional<engine::Line> won;
  // The player falls down; can never go on; is pushed by a force; jumps, in the air, too; loses a
  // state such as Jumping.
  std::optional<engine::Line> trips, ends, force, jumps, stateOff;
  std::vector<Away> aways, backs;  // parts that go; that come, and go again
  std::vector<Moved> moved;
  std::vector<Changed> belts, sizes;
  std::vector<UnnamedStat> unnamed;
  std::map<InstanceId, engine::Line> others;  // things whose other properties are set

  // The effects on the player, and those on parts.
  auto onPlayer() {
    return std::tie(harm, push, teleport, boost, trips, ends, force, jumps, stateOff, won, stage);
  }
  auto onPlayer() const {
    return std::tie(harm, push, teleport, boost, trips, ends, force, jumps, stateOff, won, stage);
  }
  auto onParts() { return std::tie(aways, backs, moved, belts, sizes); }
  auto onParts() const { return std::tie(aways, backs, moved, belts, sizes); }

  bool touchesPlayer() const {
    return std::apply([](const auto&... effect) { return (effect.has_value() || ...); },
                      onPlayer());
  }
  bool touchesParts() const {
    return std::apply([](const auto&... parts) { return (!parts.empty() || ...); }, onParts());
  }
  bool empty() const { return !touchesPlayer() && !touchesParts(); }
  // Returns true if there is progress and nothing else.
  bool onlyStage() const;
  // Returns the effects that a touch of `from` has, for `to`, to which the same functions listen.
  // Nothing if they depend on where the parts are, or concern other parts.
  std::optional<ProbeEffects> asOf(InstanceId from, InstanceId to) const;
  // Returns the line of one of the effects; of none: {}.
  engine::Line line() const;
};

}  // namespace obby::importer
