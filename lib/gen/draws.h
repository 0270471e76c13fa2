// The random numbers of a level, most of which follow its difficulty.
#pragma once

#include <cstdint>

#include "base/random.h"
#include "gen/recipe.h"
#include "gen/style.h"

namespace obby::gen {

// Rounds to a multiple of `unit`.
float rounded(float v, float unit);

class Draws {
 public:
  // --- Random numbers. Draw at most once per expression, because compilers order the evaluation of
  // operands and arguments differently, and levels would differ.
  float unit() { return random_.unit(); }
  uint32_t below(uint32_t n) { return random_.below(n); }
  uint32_t count(Count c) { return c.lo + random_.below(c.hi - c.lo + 1); }
  bool chance(float share) { return random_.unit() < share; }
  float side() { return random_.below(2) == 0 ? -1.0f : 1.0f; }
  // Returns a value between easy and hard, by the difficulty and some noise, rounded to quarters.
  float mix(const Parameter& p);
  // Like mix(), with a random sign.
  float mixEitherSign(const Parameter& p) { return eitherSign(endsOf(p)); }
  float mixEitherSign(float easy, float hard) { return eitherSign({easy, hard}); }
  // Like mix(), but returns a spin in rad/s with a random sign. A turn takes a whole number of
  // ticks at 60 ticks per second, which keeps the turn tables short (kMaxLevelRows of lib/level).
  float mixSpin(const Parameter& p);
  // Like mix(), but returns a whole number.
  uint32_t mixCount(const Parameter& p);
  // Like mix(), but by the difficulty alone, without noise or rounding.
  float steady(const Parameter& p) const;

  float difficulty() const { return difficulty_; }  // difficulty of the current obstacle, 0 to 1

 protected:
  // The recipe must outlive this object.
  Draws(const Recipe& recipe, Random random) : recipe_(&recipe), random_(random) {}

  // Values at difficulty 0 and 1.
  struct Ends {
    float easy, hard;
  };
  Ends endsOf(const Parameter& p) const;
  float mixed(Ends ends);
  float eitherSign(Ends ends);
  // Returns the share of the reach that a crossing takes, with noise of `spread`.
  float share(float spread);

  const Recipe* recipe_;
  Random random_;
  float difficulty_ = 0;
};

}  // namespace obby::gen
