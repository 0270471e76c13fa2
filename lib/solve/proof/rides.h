// Parts that take along whom they push: anywhere on their way, at no cost.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "solve/proof/few_boxes.h"
#include "solve/proof/flight.h"

namespace obby::solve {

// A part, or several near each other.
struct Pusher {
  Box pushed;   // where those are whom it pushes
  float speed;  // studs/s, at most
  bool bursts;  // or much faster, but for no longer than from one end of `pushed` to another
};

struct Ride {
  const Pusher* by;
  float way;  // studs that the player has to come to it by own speed, over others or straight
};

// Those of them that are no farther than that, the nearest first: each may be the way to the next.
inline std::vector<Ride> nearestFirst(std::vector<Ride> open, float farthest) {
  std::vector<Ride> rides;
  const auto nearer = [](const Ride& a, const Ride& b) { return a.way < b.way; };
  while (!open.empty()) {
    const auto next = std::min_element(open.begin(), open.end(), nearer);
    const Ride ride = *next;
    if (ride.way > farthest) break;
    open.erase(next);
    for (Ride& other : open) {
      other.way = std::min(other.way, ride.way + gapBetween(ride.by->pushed, other.by->pushed));
    }
    rides.push_back(ride);
  }
  return rides;
}

// Studs that somebody has to come from one box to another, where `rides` can be had on the way.
inline float wayBetween(const Box& from, const std::vector<Ride>& rides, const Box& to) {
  float least = gapBetween(from, to);
  for (const Ride& ride : rides) {
    least = std::min(least, ride.way + gapBetween(ride.by->pushed, to));
  }
  return least;
}

// So few that the ways between all of them can be looked at: near ones as one, which reaches
// farther.
inline std::vector<Pusher> fewPushers(std::vector<Pusher> pushers) {
  constexpr size_t kMost = 256;
  if (pushers.size() <= kMost) return pushers;
  std::vector<Box> boxes;
  float fastest = 0;
  bool bursts = false;
  for (const Pusher& p : pushers) {
    boxes.push_back(p.pushed);
    fastest = std::max(fastest, p.speed);
    bursts = bursts || p.bursts;
  }
  pushers.clear();
  for (const Box& box : fewBoxes(std::move(boxes), kMost)) {
    pushers.push_back({box, fastest, bursts});
  }
  return pushers;
}

}  // namespace obby::solve
