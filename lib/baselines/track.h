// Episodes in CFLGE's memory: their places, for the latent space and goals, and the decisions that
// the policy learns from. Host only.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "baselines/names.h"
#include "policy/observation.h"
#include "solve/model/problem.h"

namespace obby::baselines {

// The size of a place. A place is a state as the latent space sees it: the position of the player
// and the mean position of dynamic bodies, both relative to the start in units of four studs; the
// number of waypoints and visits reached; and a code of that set, as a share of kCodes, 0 for none.
// Velocities are left out: they alone would reveal the action, and all places would look alike.
constexpr size_t kPlace = 8;
constexpr size_t kReached = 6, kCode = 7;  // indices in a place
constexpr uint32_t kCodes = 1u << 16;

// `bodies`: (problem.level.bodyCount).
void placeOf(const Problem& problem, const sim::World& world, const sim::RigidBody* bodies,
             float* place);

// The places of one episode, before each decision and after the last.
struct Path {
  std::vector<float> places;    // (decisions + 1, kPlace)
  std::vector<uint8_t> stands;  // (decisions + 1), true with a floor under the player

  size_t size() const { return stands.size(); }
  const float* place(size_t i) const { return places.data() + i * kPlace; }
};

// The decisions of one episode.
struct Track {
  std::shared_ptr<const Path> path;
  std::vector<float> inputs;     // (decisions + 1, policy::kInputs), in the world's axes
  std::vector<uint8_t> mayJump;  // (decisions + 1)
  std::vector<uint8_t> moves;    // (decisions)
  std::vector<float> goals;      // (decisions, kPlace), goals of the player at the time
  bool ended = false;            // the game ended the episode; it was not cut off

  size_t decisions() const { return moves.size(); }
};

// The decisions of the last episodes, within a capacity.
class Memory {
 public:
  explicit Memory(size_t capacity) : capacity_(capacity) {}

  void add(std::shared_ptr<const Track> track);
  size_t size() const { return size_t(end_ - (tracks_.empty() ? end_ : tracks_.front().first)); }

  struct Place {
    const Track* track;
    size_t decision;
  };
  // `i`: below size().
  Place at(size_t i) const;

 private:
  struct Kept {
    uint64_t first;  // index of its first decision among all ever added
    std::shared_ptr<const Track> track;
  };
  size_t capacity_;
  uint64_t end_ = 0;
  std::deque<Kept> tracks_;
};

}  // namespace obby::baselines
