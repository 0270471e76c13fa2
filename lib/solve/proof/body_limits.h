// Upper bounds on what a body can do, from the physics parameters alone. docs/proof.md derives each
// number under the name that it has here.
#pragma once

#include "solve/model/problem.h"
#include "solve/proof/part_motion.h"

namespace obby::solve {

// Returns the feature of the level that prevents a bound, in words; null if there is none.
const char* unboundedPart(const level::LevelView& level);

// Returns a box around the level, the start, and the ends of teleporters.
Box allPlaces(const Problem& problem);

// A flight off a support.
struct Flight {
  float height, up;  // max height of the feet, and their max upward speed
  bool leaps;        // begins with a jump
  float radius;      // the flight begins within this radius of the support's box
};

// Lengths, in studs.
struct BodySizes {
  float ray = 0;         // horizontal radius in which floors are sensed
  float body = 0;        // radius of the colliding body, or `ray` if that is larger
  float stand = 0;       // radius in which a jump begins: `body`, or `ray` if walks are fast
  float limb = 0;        // radius in which limbs touch
  float across = 0;      // parts farther apart than this are not touched at once
  float slack = 0;       // skin, residual penetration and rounding
  float settles = 0;     // studs above the rest height at which a player may stand
  float sunk = 0;        // studs below a support's top from which a jump or fall may begin
  float maxTakeOff = 0;  // studs above the top from which a jump or fall may begin
  float overlap = 0;     // max overlap with a part after a step of travel and a tick of air turning
  float turned = 0;      // max overlap with any turn
};

// Speeds, in studs/s unless stated.
struct BodySpeeds {
  float walk = 0;      // max speed by keys, studs/s, under all boosts of the level
  float jump = 0;      // max launch speed of a jump
  float slowJump = 0;  // min launch speed of a jump, under the worst boost
  float decay = 0;     // deceleration of excess speed by keys, studs/s^2
  float turning = 0;   // speed that turning next to parts can add, studs/s
  float late = 0;      // seconds from the last tick on a floor to the end of a jump's first tick
  // For the trick of held jumps; 0 without it.
  float heldSeconds = 0;  // max time without gravity
  float heldRise = 0;     // max studs above the take-off until gravity acts, less one tick
};

class BodyLimits : public BodySizes, public BodySpeeds {
 public:
  BodyLimits(const Problem& problem, const std::vector<PartMotion>& motions);

  // Returns the min height of the feet from which a jump enters the top of a static upright block.
  // `pinched`: another part may hold the body next to it.
  float entry(float top, bool pinched) const;
  // Returns the studs by which the entry is lower for feet that arrive without a jump.
  float entryOfFalls() const { return turned - overlap; }

  // Returns the max height from which a jump or fall begins, in studs above the highest place of a
  // floor, in Running. The apex of the preceding flight was `low` to `high` studs above that place.
  float takeOff(float low, float high) const;
  // Returns the upward speed, in studs/s, that a trick with the legs gives on a floor that goes up
  // or down at `speed`.
  float thrown(float speed) const;

  // Return the apex of a flight, and the rise of a launch at `up` studs/s.
  float apex(const Flight& f) const { return f.height + apex(f.up, f.leaps); }
  float apex(float up, bool leaps) const;
  // Returns a lower bound of the rise of a launch at `up` studs/s.
  float lowApex(float up, bool leaps) const;
  // Returns the seconds until the feet are at `height` for the last time, including the ticks
  // before the take-off. Returns a negative value if they never are.
  float seconds(const Flight& f, float height) const;
  // Returns the max horizontal distance in `seconds`, in studs. `excess`: speed beyond `walk` at
  // the start.
  float sideways(float seconds, float excess) const;

  // Returns how far above a floor that goes up or down at `speed` the legs can leave the feet.
  float legsOvershoot(float speed) const;

 private:
  // Returns the distance of a free fall from rest, in studs.
  float fallOver(uint32_t steps, float gravity) const;
  float airSeconds(float w, float rise) const;
  float reachAt(float fall, bool kept) const;  // reach of the rays below the feet
  void setSpeeds(const Problem& problem, const std::vector<PartMotion>& motions);
  void setBody();
  void setTakeOff();
  void setTricks();

  const Params& p_;
  float dt_, tick_;
  float light_, heavy_;     // min and max gravity, under all boosts of the level
  float fastest_ = 0;       // max sideways speed of a player, studs/s
  uint32_t lateTicks_ = 0;  // ticks from the last one with a floor to the last possible jump
  float keptReach_ = 0;     // max studs above a floor at which it is still sensed
  float always_ = 0;        // max studs of a take-off above a floor, after a fast landing
  float slowest_ = 0;       // studs; landings from a higher apex are fast
};

}  // namespace obby::solve
