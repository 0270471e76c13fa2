// An upper bound on what a player can reach with any keys, derived from the laws of the simulator
// in docs/proof.md. A query is reported as unreachable only by this bound.
//
// A trajectory is a sequence of flights from one support to the next. A flight begins as high and
// as fast as its support allows. Walls, kill parts, avoid regions and timing are ignored. A moving
// part is everywhere on its track at once.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "solve/proof/supports.h"

namespace obby::solve {

// The first step that no player can make, on the route with the smallest missing distance. If the
// part were nearer by this much, a plain jump would reach it, unless something is in between.
struct Missing {
  uint32_t from = level::kNone, to = level::kNone;  // colliders; kNone: start or region
  float rise = 0, gap = 0;                          // studs
  bool blocked = false;                             // other parts are near the flight
  bool more = false;                                // later steps lack something, too
};

class ReachBound {
 public:
  static constexpr uint32_t kNever = 0xffffffffu;

  // `mayJump`: the query admits jumps. The problem must outlive the bound, and its level must have
  // no unboundedPart().
  ReachBound(const Problem& problem, bool mayJump);
  ReachBound(const ReachBound&) = delete;
  ReachBound& operator=(const ReachBound&) = delete;

  // Returns the min number of jumps to enter the region or touch the part; kNever if it is
  // unreachable.
  uint32_t jumpsTo(const level::TargetView& target) const;

  // Returns true if the feet could be there at any time.
  bool holds(Vec3 feet) const;

  // Returns the step that is missing to reach any of the targets.
  Missing missing(const std::vector<const level::TargetView*>& targets) const;
  Missing missing(const level::TargetView& target) const { return missing(std::vector{&target}); }

  // Returns the bounds of the feet when the target is reached, seen from above.
  Box boxOf(const level::TargetView& target) const;

  // Returns the colliders that may carry the player.
  std::vector<uint32_t> reached() const;

  // Returns the min seconds that a player takes for a horizontal distance; 0 if nothing is known.
  float secondsFor(float studs) const;

 private:
  // The end of a flight.
  struct End {
    Box box;
    float height;               // min height of the feet, after a jump
    float side = 0;             // radius around the box
    uint32_t support = kNever;  // the support at that end; kNever: none
  };
  void explore();
  void come(uint32_t support, uint32_t jumps);
  void leave(uint32_t support);
  void spread(uint32_t from, bool leaps);
  float takeOffAfter(uint32_t from, uint32_t to, const Flight& f) const;

  bool isReached(uint32_t support) const { return jumps_[support] != kNever; }
  bool mayLeap(const Support& s) const { return mayJump_ && s.carries; }
  Flight flight(uint32_t support, bool leaps) const;
  // Returns the number of jumps up to the end of the flight `f` from `support`. A held jump may go
  // on over the next floor, so it does not count.
  uint32_t jumpsAfter(uint32_t support, const Flight& f) const {
    return jumps_[support] + (f.leaps && limits_.heldSeconds == 0 ? 1 : 0);
  }
  uint32_t jumpsInto(const End& end) const;
  bool stepsInto(const Flight& f, const End& to, float distance) const;
  float reach(const Flight& f, float height, int parts) const;
  bool crosses(uint32_t from, const Flight& f, const End& to) const;
  int partsNear(uint32_t from, const Flight& f, const End& to, float studs) const;
  Missing lack(uint32_t from, const End& to) const;
  End endAt(uint32_t support) const;
  std::vector<End> endsOf(const level::TargetView& target) const;
  std::vector<End> holdersIn(const Box& box) const;

  const Problem& problem_;
  const Params& p_;
  const std::vector<PartMotion> motions_;
  const BodyLimits limits_;
  const bool mayJump_;
  std::vector<Support> supports_;
  const BoxIndex index_;  // index of the supports' boxes, seen from above
  float pushed_ = 0;      // max studs/s by which parts next to a flight push it
  float tossed_ = 0;      // max studs/s upward that a support gives
  float lowest_ = 1e30f;  // lowest entry of all supports
  // explore() changes these until no support is reached higher, faster or with fewer jumps.
  std::vector<uint32_t> jumps_;  // (supports), min jumps to reach it, or kNever
  std::deque<uint32_t> open_;    // supports whose flights may reach more
  std::vector<bool> isOpen_;     // (supports)
  float excess_ = 0;             // max speed of a player beyond walking, studs/s
  bool wild_ = false;
};

}  // namespace obby::solve
