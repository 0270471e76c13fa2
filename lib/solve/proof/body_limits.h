// Upper bounds on what a body can do, from the physics parameters alone. Each number is derived in
// docs/proof.md, under the name that it has here.
#pragma once

#include "solve/model/problem.h"
#include "solve/proof/part_motion.h"

namespace obby::solve {

// Names what keeps the bound from saying anything; null if nothing does.
const char* unboundedPart(const level::LevelView& level);

// The level, the start, and where teleporters lead.
Box allPlaces(const Problem& problem);

// One way off a support.
struct Flight {
  float height, up;  // of the feet, at the highest, and their speed
  bool leaps;        // by a jump
  float radius;      // around the support's box in which it begins
};

class BodyLimits {
 public:
  BodyLimits(const Problem& problem, const std::vector<PartMotion>& motions);

  // --- bodies
  float ray = 0;      // radius in which floors are sensed, seen from above
  float body = 0;     // radius of the colliding body, or `ray` where that is larger
  float stand = 0;    // in which a jump begins: `ray`, where a tick of walking leads beyond `body`
  float limb = 0;     // radius in which limbs touch
  float across = 0;   // parts that are farther apart are not touched at once
  float slack = 0;    // studs: skin, what push-out leaves, rounding
  float settles = 0;  // studs above its rest height that a player may stand
  float sunk = 0;     // studs below a support's top from which a jump or fall may begin
  float mostTakeOff = 0;  // studs above it, the same
  float overlap = 0;      // with a part, by one step of travel and one tick of a turn in the air
  float turned = 0;       // the same by any turn
  // --- speeds
  float walk = 0;      // by keys, studs/s, under all boosts of the level
  float jump = 0;      // launch of a jump
  float slowJump = 0;  // the same under the boost that is worst for it
  float decay = 0;     // by which keys take back what is faster, studs/s^2
  float turning = 0;   // studs/s that turns beside parts push the body on
  float late = 0;      // seconds from the last floor to the end of a jump's first tick
  // --- jumps that are held, a trick; 0 without it
  float heldSeconds = 0;  // at most
  float heldRise = 0;     // studs above the take-off where gravity begins to act, but for a tick

  // Lowest feet that a static upright block takes onto its top, by a jump. `pinched`: another part
  // may hold the body beside it.
  float entry(float top, bool pinched) const;
  // Studs lower for feet that come without a jump.
  float entryOfFalls() const { return turned - overlap; }

  // Feet above the highest place of a floor at most, in Running, after a flight whose apex is from
  // `low` to `high` above it. A jump or fall begins there.
  float takeOff(float low, float high) const;
  // Studs/s upward that legs give by a trick on a floor that goes up or down at `speed`.
  float thrown(float speed) const;

  // Height of a flight, and that of launches at `up` studs/s above where they begin.
  float apex(const Flight& f) const { return f.height + apex(f.up, f.leaps); }
  float apex(float up, bool leaps) const;
  // Lower bound of the height of a launch at `up`.
  float lowApex(float up, bool leaps) const;
  // Seconds until the feet are at `height` for the last time, with the ticks before the take-off;
  // below 0: never.
  float seconds(const Flight& f, float height) const;
  // Studs sideways in that time. `excess`: speed beyond `walk` at the start.
  float sideways(float seconds, float excess) const;

  // How far above a floor that goes up or down at `speed` the legs can leave the feet.
  float legsOvershoot(float speed) const;

 private:
  // Studs of a free fall from rest.
  float fallOver(uint32_t steps, float gravity) const;
  float airSeconds(float w, float rise) const;
  float reachAt(float fall, bool kept) const;  // of the rays below the feet
  void setSpeeds(const Problem& problem, const std::vector<PartMotion>& motions);
  void setBody();
  void setTakeOff();
  void setTricks();

  const Params& p_;
  float dt_, tick_;
  float light_, heavy_;     // the least and the most gravity, under all boosts of the level
  float fastest_ = 0;       // sideways of anybody, studs/s
  uint32_t lateTicks_ = 0;  // from the last tick with a floor to the last jump
  float keptReach_ = 0;     // studs above a floor up to which it is sensed
  float always_ = 0;        // studs above a floor that a fast landing leaves
  float slowest_ = 0;       // studs: landings from a higher apex are fast
};

}  // namespace obby::solve
