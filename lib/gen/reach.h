// How far and how high a player can jump at most, from the physics parameters: what margins are
// fractions of. Close to what practice allows (docs/generator.md), neither a proof nor a guarantee.
#pragma once

#include "level/params.h"

namespace obby::gen {

class Reach {
 public:
  explicit Reach(const Params& params) : p_(params) {}

  // Widest gap onto a floor `rise` studs higher (negative: lower); 0: too high for any. Studs.
  float gap(float rise) const;
  // Widest gap down to the lowest floor that an obstacle has next to another. Studs.
  float widest() const;
  // Highest ledge that a jump and the legs get onto. Studs.
  float rise() const { return riseFrom(p_.jumpSpeed); }
  // Highest that the feet come in a jump. Studs, at least half a one.
  float apex() const;
  // The same as rise() for a player who is thrown upward with that many studs/s.
  float riseFrom(float upward) const;
  // Widest gap that is crossed by walking off the edge.
  float walkedGap() const;
  // Studs/s upward that bring the feet that high.
  float speedFor(float height) const;
  // Are these measures cut, as those of such a world would make levels of thousands of studs? What
  // is planted beyond them may then be within reach.
  bool cut() const;
  // Longest time in the air between floors of one height, seconds.
  float flight() const;

  const Params& params() const { return p_; }

 private:
  float legs() const;
  float gravity() const;

  Params p_;
};

}  // namespace obby::gen
