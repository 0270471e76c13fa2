#include "gen/draws.h"

#include "math/lanes.h"

namespace obby::gen {

namespace {

// Shares of the widest gap and the highest ledge, from trivial to limit.
constexpr float kMinShare = 0.25f, kMaxShare = 0.93f;
constexpr float kMixSpread = 0.08f;  // noise added to the difficulty

}  // namespace

float rounded(float v, float unit) {
  const float n = v / unit;
  return float(int32_t(n + (n < 0 ? -0.5f : 0.5f))) * unit;
}

Draws::Ends Draws::endsOf(const Parameter& p) const {
  for (const Setting& s : recipe_->parameters) {
    if (s.parameter == &p) return {s.easy, s.hard};
  }
  return {p.easy, p.hard};
}

float Draws::mixed(Ends ends) {
  const float t = clampf(difficulty_ + kMixSpread * (2 * unit() - 1), 0.0f, 1.0f);
  return rounded(ends.easy + (ends.hard - ends.easy) * t, 0.25f);
}

float Draws::mix(const Parameter& p) { return mixed(endsOf(p)); }

float Draws::eitherSign(Ends ends) {
  const float far = mixed(ends);
  return far * side();
}

float Draws::mixSpin(const Parameter& p) {
  constexpr float kTicksATurn = 2 * 3.14159265f * 60;  // ticks of a turn at 1 rad/s and 60 ticks/s
  const float speed = mixEitherSign(p);
  return kTicksATurn / rounded(kTicksATurn / speed, 1);
}

uint32_t Draws::mixCount(const Parameter& p) {
  const Ends ends = endsOf(p);
  const float t = clampf(difficulty_ + 0.3f * (2 * unit() - 1), 0.0f, 1.0f);
  return uint32_t(ends.easy + (ends.hard - ends.easy) * t + 0.5f);
}

float Draws::steady(const Parameter& p) const {
  const Ends ends = endsOf(p);
  return ends.easy + (ends.hard - ends.easy) * difficulty_;
}

float Draws::share(float spread) {
  const float middle = kMinShare + (kMaxShare - kMinShare) * difficulty_;
  return minf(middle + spread * (2 * unit() - 1), kMaxShare);
}

}  // namespace obby::gen
