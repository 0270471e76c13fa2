// Trials of one segment of a solution, played together in SIMD lanes.
#pragma once

#include <vector>

#include "solve/report/difficulty/noisy_player.h"

namespace obby::solve {

class Trials {
 public:
  // `rest` must outlive the trials.
  explicit Trials(const LastSegments& rest) : rest_(rest) {}

  // Adds a trial from the recorded state at the start of the segment. The player is moved by
  // `offset` (studs) if the same part carries a player there.
  void add(NoisyPlayer player, Vec3 offset = {});

  // Plays all trials and returns which of them passed, in the order of add().
  std::vector<bool> run();

 private:
  enum class Fate : uint8_t { playing, passed, failed };
  struct Member {
    NoisyPlayer player;
    sim::World world;
    Fate fate = Fate::playing;
    uint32_t stays = 0;  // ticks in a row at the end of the segment
  };

  sim::RigidBody* bodiesOf(size_t member);
  void tick();
  void judge(Member& m, sim::RigidBody* bodies) const;

  const LastSegments& rest_;
  std::vector<Member> members_;
  std::vector<sim::RigidBody> bodies_;  // (members x level.bodyCount)
  std::vector<size_t> playing_;
  // Arguments for the simulator, one for each trial in playing_.
  std::vector<sim::World*> worlds_;
  std::vector<sim::RigidBody*> bodyPointers_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::solve
