// What the policy can do at each decision: 16 directions or standing, each with and without jump.
#pragma once

#include "base/random.h"
#include "math/exponential.h"
#include "policy/observation.h"

namespace obby::policy {

constexpr int kHeadings = 16;
constexpr int kMoves = 2 * (kHeadings + 1);  // 34; odd ones jump
constexpr uint32_t kDecisionTicks = 3;       // a move is held so long: 20 a second at 60 ticks

OBBY_DEVICE bool jumps(int move) { return (move & 1) != 0; }
// No branch, so that loops over the moves become lanes.
OBBY_DEVICE bool isAllowed(int move, bool mayJump) { return !jumps(move) | mayJump; }

// `ahead`: of the observation that led to the move.
OBBY_DEVICE sim::Action actionOf(int move, Turns ahead) {
  const int direction = move >> 1;
  const bool walk = direction < kHeadings;
  return {walk ? Turns(ahead + direction * (65536 / kHeadings)) : Turns(0), walk, jumps(move)};
}

// Is jumping of any use, and within the query's limits?
OBBY_DEVICE bool jumpAllowed(const Scene& s, const sim::World& w) {
  return mayJump(s.level, w) && sim::jumpsLeft(s.query, w) > 0;
}

// The likeliest of the moves that are allowed; the first of several.
OBBY_DEVICE int likeliest(const float* logits, bool mayJump) {
  int best = 0;
  for (int m = 1; m < kMoves; ++m) {
    if (!isAllowed(m, mayJump)) continue;
    if (logits[m] > logits[best]) best = m;
  }
  return best;
}

// A move with the probability that the logits give it among those that are allowed.
OBBY_DEVICE int draw(const float* logits, bool mayJump, Random& random) {
  const float most = logits[likeliest(logits, mayJump)];
  float odds[kMoves];
  float sum = 0;
  for (int m = 0; m < kMoves; ++m) {
    odds[m] = isAllowed(m, mayJump) ? expNegative(logits[m] - most) : 0.0f;
    sum += odds[m];
  }
  float rest = random.unit() * sum;
  int last = 0;
  for (int m = 0; m < kMoves; ++m) {
    if (!isAllowed(m, mayJump)) continue;
    last = m;
    rest -= odds[m];
    if (rest < 0) break;
  }
  return last;
}

}  // namespace obby::policy
