// Trials of one segment of a solution, played together in SIMD lanes.
#pragma once

#include <vector>

#include "solve/report/difficulty/noisy_player.h"

namespace obby::solve {

class Trials {
 public:
  // The leg must outlive the trials.
  explicit Trials(const Leg& leg) : leg_(leg) {}

  // One more, from the state in which the recorded player begins the segment, moved by `offset`
  // (studs) where the player is carried by the same part there.
  void add(NoisyPlayer player, Vec3 offset = {});

  // Plays all of them; which of them did the segment, in the order of add().
  std::vector<bool> run();

 private:
  enum class Fate : uint8_t { playing, passed, failed };
  struct Member {
    NoisyPlayer player;
    sim::World world;
    Fate fate = Fate::playing;
    uint32_t stays = 0;  // ticks for which it has been where the segment ends
  };

  sim::LooseBody* looseOf(size_t member);
  void tick();
  void judge(Member& m, sim::LooseBody* loose) const;

  const Leg& leg_;
  std::vector<Member> members_;
  std::vector<sim::LooseBody> loose_;  // (members x level.looseCount)
  std::vector<size_t> playing_;
  // Of those, for the simulator.
  std::vector<sim::World*> worlds_;
  std::vector<sim::LooseBody*> bodies_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::solve
