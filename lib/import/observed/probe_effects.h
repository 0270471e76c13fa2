// The effects of one touch or use, on the player and on parts.
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/report.h"
#include "import/draft/draft.h"

namespace obby::importer {

struct Harmful {
  double damage = 0, cooldown = 0;
  bool lasts = false;      // it goes on after the player has left; the damage is that of one touch
  bool stoppable = false;  // a force field stops it
  engine::Line line;
};
struct Push {
  Vec3 velocity;
  bool keepsSideways = false;
  engine::Line line;
  double seconds = 0;  // duration of a mover's velocity; 0: set once

  // Returns the upward launch speed that reaches the height of the held velocity: v t + v^2 / 2g.
  float launchSpeed(float gravity) const {
    const float v = velocity.y;
    return v > 0 && seconds > 0 ? std::sqrt(v * v + 2 * gravity * v * float(seconds)) : v;
  }
};
struct Teleported {
  Vec3 feet;
  bool turns = false;
  float yaw = 0;
  engine::Line line;
};
struct Booster {
  float walk = 1, jump = 1, gravity = 1;  // factors of the former values; < 0: floats up
  double seconds = 0;  // duration from the last touch; 0: ends when the player leaves
  bool forever = false;
  bool resets = false;  // restores the former values and does nothing else
  engine::Line line;
};
// Progress of the player that scripts store.
struct StageSet {
  std::optional<int> number;         // a number in leaderstats or the like
  std::optional<int64_t> team;       // colour of the player's new team
  InstanceId respawn = kNoInstance;  // SpawnLocation where the player respawns from now on
  engine::Line line;
};
// A number of the player that scripts store under an uninformative name.
struct UnnamedStat {
  int number = 0;
  engine::Line line;
};
struct Away {
  InstanceId part = kNoInstance;
  double delay = 0;
  std::optional<double> seconds;  // nullopt: it did not come back
  engine::Line line;
  bool held = false;  // it came back as the player left; `seconds` counts from then
};
struct Moved {
  InstanceId part = kNoInstance;
  std::vector<Pose> poses;          // one pose per frame, from the touch on
  InstanceId driver = kNoInstance;  // constraint or mover that moves it
  engine::Line line;
  std::optional<Motion> outlasting;  // motion of tweens that still play at the probe's end
};

// A part that changes, and the script line that changes it.
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
  // Lines that make the player fall down, that end its play, that push it by a force, that make it
  // jump (also in the air), and that disable a state such as Jumping.
  std::optional<engine::Line> trips, ends, force, jumps, stateOff;
  std::vector<Away> aways, backs;  // parts that vanish; parts that appear (either may end)
  std::vector<Moved> moved;
  std::vector<Changed> belts, sizes;
  std::vector<UnnamedStat> unnamed;
  std::map<InstanceId, engine::Line> others;  // parts whose other properties are set

  // onPlayer returns the effects on the player, onParts those on parts.
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
  // Returns true if progress is the only effect.
  bool onlyStage() const;
  // Turns the effects of a touch of `from` into those of a touch of `to`, a part with the same
  // listeners. Returns nullopt if the effects depend on the parts' positions or concern other
  // parts.
  std::optional<ProbeEffects> asOf(InstanceId from, InstanceId to) const;
  // Returns the line of one of the effects, or {} if there is none.
  engine::Line line() const;
};

}  // namespace obby::importer
