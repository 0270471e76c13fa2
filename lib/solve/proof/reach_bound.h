// What a player can reach at most, whatever the keys: a sound over-approximation, from which alone
// a query is said to be unreachable.
//
// A playthrough is a sequence of flights from one thing that carries the player to the next. Each
// flight is a parabola that starts as high and as fast as anything reachable allows; walls, kill
// parts, avoid regions and timing are ignored; moving parts are everywhere on their way at once,
// and take along for nothing whom they push, as does what they push somebody into; parts that
// vanish, open or fall are there and away. docs/queries.md says what is left out.
//
// That all parts are there for the player is taken for granted: of crowdedPlaces() (crowding.h) it
// is not so, and who can come into one can come anywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "solve/proof/box_index.h"
#include "solve/proof/flight.h"
#include "solve/proof/put_out.h"
#include "solve/proof/rides.h"
#include "solve/proof/supports.h"

namespace obby::solve {

// A step that nobody can make: the least of those that lead out of what is reached.
struct Missing {
  uint32_t from = level::kNone, to = level::kNone;  // colliders; none: the start, the region
  float rise = 0, gap = 0;                          // studs that a player lacks, at least
};

class ReachBound {
 public:
  static constexpr uint32_t kNever = 0xffffffffu;

  // `mayJump`: the query admits jumps. The problem must outlive the bound, and its level have no
  // unboundedPart().
  ReachBound(const Problem& problem, bool mayJump);
  ReachBound(const ReachBound&) = delete;  // points into itself
  ReachBound& operator=(const ReachBound&) = delete;

  // Fewest jumps on the way into the region, or to touching the part; kNever: there is no way.
  uint32_t jumpsTo(const level::TargetView& target) const;

  // Could the feet be there at any time?
  bool holds(Vec3 feet) const;

  // Could the feet be in any of these boxes at any time?
  bool comesInto(const std::vector<Box>& places) const;

  // The step out of what is reached that lacks least, to another part or into any of the targets.
  Missing missing(const std::vector<const level::TargetView*>& targets) const;
  Missing missing(const level::TargetView& target) const { return missing(std::vector{&target}); }

  // Where the feet are when the target is reached, at the least height its floor less a body's.
  Box boxOf(const level::TargetView& target) const;

  // Colliders that may carry the player.
  std::vector<uint32_t> reached() const;

  // Fastest horizontal motion of anyone, studs/s, but of those who are pressed out of a wedge;
  // infinite where something moves players at once.
  float fastest() const;

  // Where such wedges may take somebody along at any speed, by how far from there: wayBetween()
  // gives the studs that are left.
  std::vector<Ride> ownRides(const Box& from) const;

  // Studs from one box to the other that somebody comes at fastest(), at least, with these
  // ownRides(): less than wayBetween() by what the parts on the way put them out by.
  float wayPast(const Box& from, const std::vector<Ride>& rides, const Box& to) const;

  // How far jumps may move somebody at once, besides. Not to be asked where fastest() is infinite.
  std::vector<PutOut> putOuts() const;

 private:
  void explore();
  void spread(uint32_t from, std::vector<uint32_t>& now, std::vector<uint32_t>& later);
  template <class Near>
  void forNear(const Box& feet, const std::vector<Ride>& rides, float farthest, Near&& near) const;
  Launch launch(const Support& s, bool jumping) const;
  // The highest that there is from it.
  Launch launch(const Support& s) const { return launch(s, mayJump_ && s.carries); }
  bool crosses(const Launch& l, float gap, const Support& to, bool jumping) const;
  // That can be met in a flight from there before the feet are below `lowest`.
  std::vector<Ride> ridesFrom(const Support& s, float lowest) const;
  std::vector<Ride> ridesOn(const Launch& l, float lowest) const;
  // reach_slopes.cpp
  float fastestReached() const;
  float fastestOfAll() const;
  bool isSteepOnly(const Support& s) const;
  bool isIce(const Support& s) const;
  bool glancesFar(float upward, float most) const;
  bool glancesOver(bool ice) const;
  float rampSpeed(const Support& s) const;
  // reach_falls.cpp
  struct Fall {
    Launch from;
    float top;  // feet, at the highest
  };
  Fall fallFrom(const Support& s, float reached) const;
  std::vector<float> highestFalls() const;
  bool spreadFalls(const std::vector<size_t>& from, const std::vector<size_t>& slopes,
                   std::vector<float>& highest) const;
  bool isSlopeNear(size_t support, float studs) const;
  float speedAfter(float before, float fall, bool together) const;
  struct Glance {
    float after;   // studs/s sideways, from then on
    float atOnce;  // studs beyond those, in the first tick
    // Studs from the feet then up to where a flight from the slope is taken to begin, which may be
    // the longer one; negative: they may land on ice, which leaves them as fast and takes them
    // anywhere.
    float below;
  };
  Glance glanceAt(float speed, float below) const;
  bool outruns(const Glance& g, float more) const;
  float turnedAside(float given, float more) const;
  // reach_edges.cpp
  struct Heights {
    float apex, upward;  // of any feet, studs and studs/s
    float beside;        // studs that turning beside a part gains
    float climbed;       // studs of a substep of a climb, which is never cut up
  };
  Heights heights() const;
  float putOutPast(const Support& s, const Heights& of) const;

  const Problem& problem_;
  const Params& p_;
  const bool mayJump_;
  const float jumpSpeed_, walkSpeed_;  // by keys, under all boosts
  std::vector<Support> supports_;
  const BoxIndex index_;                                   // of their feet, from above
  float lowest_ = std::numeric_limits<float>::infinity();  // entry of all supports
  std::vector<Pusher> pushers_;
  bool slopes_ = false;          // is any support tilted?
  std::vector<uint32_t> jumps_;  // (supports): fewest on the way there; kNever
  Flight flight_;
};

}  // namespace obby::solve
