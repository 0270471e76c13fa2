// The max jump distance and height under the physics parameters, the basis of all margins. They are
// close to what a player can do (docs/generator.md), but not proven.
#pragma once

#include "level/params.h"

namespace obby::gen {

class Reach {
 public:
  explicit Reach(const Params& params) : p_(params) {}

  // Returns the widest gap onto a floor `rise` studs higher (negative: lower), or 0 if that is
  // too high. Studs.
  float gap(float rise) const;
  // Returns the widest gap down to the lowest floor next to an obstacle. Studs.
  float widest() const;
  // Returns the highest ledge that a jump can reach, with the legs' help. Studs.
  float rise() const { return riseFrom(p_.jumpSpeed); }
  // Returns the max height of the feet in a jump. Studs, at least 0.5.
  float apex() const;
  // Returns the highest ledge after a launch at `upward` studs/s.
  float riseFrom(float upward) const;
  // Returns the widest gap that can be crossed by walking off the edge. Studs.
  float walkedGap() const;
  // Returns the upward speed that lifts the feet to a height, studs/s.
  float speedFor(float height) const;
  // Returns true if these measures are clamped, which keeps levels from being thousands of studs
  // long. A crossing made impossible may then be within reach.
  bool cut() const;
  // Returns the longest time in the air between floors of equal height, seconds.
  float flight() const;

  const Params& params() const { return p_; }

 private:
  float legs() const;
  float gravity() const;

  Params p_;
};

}  // namespace obby::gen
