// What a player can reach at most, whatever the keys: an upper bound, derived from the laws of the
// simulator in docs/proof.md. A query is said to be unreachable from it alone.
//
// A trajectory is a sequence of flights from one support to the next. A flight begins as high and
// as fast as its support allows; walls, kill parts, avoid regions and timing are ignored; moving
// parts are everywhere on their track at once.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "solve/proof/supports.h"

namespace obby::solve {

// The first step that no player can make, on the route that lacks least. A part that is nearer by
// this is reached by a plain jump, if nothing stands in the way.
struct Missing {
  uint32_t from = level::kNone, to = level::kNone;  // colliders; none: the start, the region
  float rise = 0, gap = 0;                          // studs
  bool blocked = false;                             // parts stand near the way
  bool more = false;                                // steps behind it lack something, too
};

class ReachBound {
 public:
  static constexpr uint32_t kNever = 0xffffffffu;

  // `mayJump`: the query admits jumps. The problem must outlive the bound, and its level have no
  // unboundedPart().
  ReachBound(const Problem& problem, bool mayJump);
  ReachBound(const ReachBound&) = delete;
  ReachBound& operator=(const ReachBound&) = delete;

  // Fewest jumps on the way into the region, or to touching the part; kNever: there is no way.
  uint32_t jumpsTo(const level::TargetView& target) const;

  // Could the feet be there at any time?
  bool holds(Vec3 feet) const;

  // On the way to any of the targets.
  Missing missing(const std::vector<const level::TargetView*>& targets) const;
  Missing missing(const level::TargetView& target) const { return missing(std::vector{&target}); }

  // Where the feet are when the target is reached, seen from above.
  Box boxOf(const level::TargetView& target) const;

  // Colliders that may carry the player.
  std::vector<uint32_t> reached() const;

  // Fewest seconds that a player takes for so many studs, seen from above; 0: nothing is known.
  float secondsFor(float studs) const;

 private:
  // Where a flight is to end.
  struct End {
    Box box;
    float height;               // least of the feet, after a jump
    float side = 0;             // radius around the box
    uint32_t support = kNever;  // itself; kNever: none
  };
  void explore();
  void come(uint32_t support, uint32_t jumps);
  void leave(uint32_t support);
  void spread(uint32_t from, bool leaps);
  float takeOffAfter(uint32_t from, uint32_t to, const Flight& f) const;

  bool isReached(uint32_t support) const { return jumps_[support] != kNever; }
  bool mayLeap(const Support& s) const { return mayJump_ && s.carries; }
  Flight flight(uint32_t support, bool leaps) const;
  // Jumps on the way to where that flight ends. A held jump goes on over the next floor, too.
  uint32_t jumpsAfter(uint32_t support, const Flight& f) const {
    return jumps_[support] + (f.leaps && limits_.heldSeconds == 0 ? 1 : 0);
  }
  uint32_t jumpsInto(const End& end) const;
  bool stepsInto(const Flight& f, const End& to, float way) const;
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
  const BoxIndex index_;  // of their boxes, from above
  float pushed_ = 0;      // studs/s by parts beside a flight
  float tossed_ = 0;      // studs/s upward that any of them gives
  float lowest_ = 1e30f;  // entry of all supports
  // What explore() changes until nothing is higher, faster or sooner.
  std::vector<uint32_t> jumps_;  // (supports): fewest on the way there; kNever
  std::deque<uint32_t> open_;    // supports whose flights may reach more
  std::vector<bool> isOpen_;     // (supports)
  float excess_ = 0;             // speed beyond walking of anybody, studs/s
  bool wild_ = false;
};

}  // namespace obby::solve
