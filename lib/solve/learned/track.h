// What CFLGE remembers of playthroughs: the places that they came through, which latent space and
// goals are made of, and the decisions that the policy learns from. Host only.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "policy/observation.h"
#include "solve/model/problem.h"

namespace obby::solve::learned {

// A state as latent space sees it: where the player is and where the loose bodies are, on average;
// both from the start, in units of four studs; how many waypoints and visits are behind, and which:
// a code below kCodes, as a share of that, 0 for none. Velocities are left out: from them alone an
// action could be told, and all places would look alike.
constexpr size_t kPlace = 8;
constexpr size_t kReached = 6, kCode = 7;  // of it
constexpr uint32_t kCodes = 1u << 16;

// `loose`: (problem.level.looseCount).
void placeOf(const Problem& problem, const sim::World& world, const sim::LooseBody* loose,
             float* place);

// The places of one playthrough, before each decision and after the last.
struct Path {
  std::vector<float> places;    // (decisions + 1, kPlace)
  std::vector<uint8_t> stands;  // (decisions + 1), the player has a floor there

  size_t size() const { return stands.size(); }
  const float* place(size_t i) const { return places.data() + i * kPlace; }
};

// The decisions of one playthrough.
struct Track {
  std::shared_ptr<const Path> path;
  std::vector<float> inputs;     // (decisions + 1, policy::kInputs), in the world's axes
  std::vector<uint8_t> mayJump;  // (decisions + 1)
  std::vector<uint8_t> moves;    // (decisions)
  std::vector<float> goals;      // (decisions, kPlace), what the player was to reach
  bool ended = false;            // for the player, instead of being cut

  size_t decisions() const { return moves.size(); }
};

// The decisions of the last playthroughs, as many as there is room for.
class Memory {
 public:
  explicit Memory(size_t room) : room_(room) {}

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
    uint64_t first;  // of its decisions among all that were ever added
    std::shared_ptr<const Track> track;
  };
  size_t room_;
  uint64_t end_ = 0;
  std::deque<Kept> tracks_;
};

}  // namespace obby::solve::learned
