// Upper bounds on what a body can do, from the physics parameters alone. Each number is derived in
// docs/proof.md, under the name that it has here.
#pragma once

#include "solve/proof/boxes.h"
#include "solve/proof/part_motion.h"

namespace obby::solve {

// Names what keeps the bound from saying anything; null if nothing does.
const char* unboundedPart(const level::LevelView& level);

// The level, the start, and where teleporters lead.
Box allPlaces(const Problem& problem);

// Fastest walk and launch of a jump under all boosts of the level, studs/s.
float fastestWalk(const level::LevelView& level);
float fastestJump(const level::LevelView& level);

// Heights of feet, studs.
struct Span {
  float lo, hi;
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
  float overlap = 0;  // with a part, by one step of travel and one tick of a turn in the air
  float turned = 0;   // the same by any turn
  bool staysOut = false;  // no jump leads the axis of the body into a part in its first tick

  float turning = 0;  // studs/s that turns beside parts push the body on
  // --- speeds
  float walk = 0;      // by keys, studs/s
  float fastest = 0;   // sideways of anybody, studs/s
  float jump = 0;      // launch of a jump
  float slowJump = 0;  // the same under the boost that is worst for it
  float decay = 0;     // by which keys take back what is faster, studs/s^2
  // --- tricks: 0 where they are not allowed
  float thrown = 0;       // studs/s upward that legs give at most, on a floor that stands
  float heldSeconds = 0;  // for which a jump is held at most

  float landedTakeOff = 0;  // studs: no takeOff() or keptTakeOff() is higher

  // Lowest feet that a static upright block takes onto its top, by feet that fall off a floor and
  // by feet in a jump. `pinched`: another part may hold the body beside it.
  float entryFalling(float top) const;
  float entryLeaping(float top, bool pinched) const;

  // Feet above a floor in Running, at most, after a flight whose apex is in `heads`, relative to
  // the highest place of the floor, which goes up at `rising` studs/s. A jump or fall begins there.
  float takeOff(Span heads, float rising) const;
  // The same where the feet came off a higher floor in Running, by `drop` studs.
  float keptTakeOff(float drop) const;
  float mostTakeOff() const;
  // Where gravity begins to act on a jump at `up` studs/s that begins at `takeOff`, studs above a
  // floor.
  float letGo(float takeOff, float up) const;
  // Studs/s upward that the legs give on a floor that goes up or down at `speed`.
  float thrownBy(float speed) const { return thrown + throwGain_ * speed * tick_; }
  // Studs below a support's top from which a jump or fall may begin.
  float sunk() const { return sunk_; }

  // Apex above the take-off of a launch at `up` studs/s: of a jump, and of a body that is let go.
  float leapApex(float up) const;
  float fallApex(float up) const;

  // Seconds until the feet are `rise` above the take-off for the last time; below 0: never. With
  // the ticks before the take-off.
  float leapSeconds(float up, float rise) const;
  float fallSeconds(float up, float rise) const;

  // Studs sideways in that time. `excess`: speed beyond `walk` at the start.
  float sideways(float seconds, float excess) const;

  // How far above a floor that goes up or down at `speed` the legs can leave the feet.
  float legsOvershoot(float speed) const;

  const Params& params() const { return p_; }

 private:
  float fallOver(uint32_t steps) const;  // studs of a free fall from rest
  float airSeconds(float w, float rise) const;
  float nearRest() const { return gravity_ * tick_ * tick_ * 0.5f + slack; }  // studs, of a tick
  float settled(float speed) const;  // height above a floor that is acquired at that fall, Landed
  float reachAt(float fall, bool kept) const;
  void setSpeeds(const Problem& problem, const std::vector<PartMotion>& motions);
  void setBody();
  void setTakeOff();
  void setTricks();
  void setThrown();

  const Params& p_;
  float dt_, tick_, gravity_;
  uint32_t landedSteps_ = 0;  // from the landing to the first jump
  uint32_t lateTicks_ = 0;    // from the last tick with a floor to the last jump
  float sunk_ = 0, always_ = 0, graceFall_ = 0, keptReach_ = 0, slowRate_ = 0;
  float throwGain_ = 0;  // of `thrown`, 1/s: by a stud that the feet are lower
};

}  // namespace obby::solve
