// What a player can reach at most, whatever the keys: an upper bound, derived from the laws of the
// simulator in docs/proof.md. A query is said to be unreachable from it alone.
//
// A trajectory is a sequence of flights from one support to the next. A flight begins as high and
// as fast as its support allows; walls, kill parts, avoid regions and timing are ignored; moving
// parts are everywhere on their track at once.
//
// It takes for granted that the simulator looks at all parts near a player: where it does not
// (crowding.h), nothing is known.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/proof/box_index.h"
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

  // Could the feet be in any of these boxes at any time?
  bool comesInto(const std::vector<Box>& places) const;

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
  // One way off a support.
  struct Flight {
    float height, up;  // of the feet, at the highest, and their speed
    bool leaps;        // by a jump
    float radius;      // around the support's box in which it begins
  };
  // Where a flight is to end.
  struct End {
    Box box;
    float falling, leaping;  // least heights of the feet
    float plain;             // for a player who lands on the rays
    float side;              // radius around the box
    uint32_t support;        // itself, no push is counted of it; kNever: none
  };
  void explore();
  bool round();
  void spread(uint32_t from, std::vector<uint32_t>& now, std::vector<uint32_t>& later);
  float takeOffAfter(uint32_t from, uint32_t to, const Flight& f) const;
  bool comesOver(uint32_t from, uint32_t to, const Flight& f) const;
  void noteReached(uint32_t support);
  static bool raises(float value, float to) { return to > value + 1e-4f; }
  bool raise(float& value, float to);

  float tossOf(uint32_t support) const;
  Flight fall(uint32_t support) const;
  Flight leap(uint32_t support) const;
  // A held jump goes on over the next floor, too.
  uint32_t jumpsOfLeap() const { return limits_.heldSeconds > 0 ? 0 : 1; }
  bool leaps(const Support& s) const { return mayJump_ && s.carries; }
  float apex(const Flight& f) const;
  float reach(const Flight& f, float height) const;
  bool crosses(uint32_t from, const Flight& f, const End& to) const;
  bool stepsInto(const Flight& f, const Support& to, float way) const;
  int partsNear(uint32_t from, const Flight& f, const End& to, float studs) const;
  float secondsOf(const Flight& f, float height) const;
  float wayTo(uint32_t from, const End& to) const;
  uint32_t jumpsFrom(uint32_t support, const End& end) const;
  Missing lack(uint32_t from, const End& to) const;
  End endAt(uint32_t support) const;
  End endAt(const level::TargetView& target) const;
  std::vector<uint32_t> holdersIn(const level::TargetView& target) const;
  void standOn(End& region) const;
  bool isReached(uint32_t support) const { return jumps_[support] != kNever; }

  const Problem& problem_;
  const Params& p_;
  const std::vector<PartMotion> motions_;
  const BodyLimits limits_;
  const bool mayJump_;
  std::vector<Support> supports_;
  const BoxIndex index_;  // of their boxes, from above
  float pushed_ = 0;      // studs/s by parts beside a flight
  float lowest_ = 1e30f;  // entry of all supports
  // What the rounds of explore() raise until nothing changes.
  std::vector<uint32_t> jumps_;  // (supports): fewest on the way there; kNever
  std::vector<float> takeOff_;   // (supports): studs above top and lift
  float excess_ = 0;             // speed beyond walking of anybody, studs/s
  float tossed_ = 0;             // upward
  bool wild_ = false, changed_ = false;
};

}  // namespace obby::solve
