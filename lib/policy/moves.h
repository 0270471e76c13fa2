// The policy's choices at each decision: 16 directions or standing, each with and without a jump.
#pragma once

#include "base/random.h"
#include "math/exponential.h"
#include "policy/observation.h"

namespace obby::policy {

constexpr int kHeadings = 16;
constexpr int kMoves = 2 * (kHeadings + 1);  // 34; odd ones jump
constexpr uint32_t kDecisionTicks = 3;       // a move is held this long, 20 a second at 60 ticks/s

OBBY_DEVICE bool jumps(int move) { return (move & 1) != 0; }
// No branch, so that the compiler can vectorize loops over the moves.
OBBY_DEVICE bool isAllowed(int move, bool mayJump) { return !jumps(move) | mayJump; }

// `ahead` is the direction of the observation that led to the move.
OBBY_DEVICE sim::Action actionOf(int move, Turns ahead) {
  const int direction = move >> 1;
  const bool walk = direction < kHeadings;
  return {walk ? Turns(ahead + direction * (65536 / kHeadings)) : Turns(0), walk, jumps(move)};
}

// Returns true if jumping can have an effect and the query's limits allow it.
OBBY_DEVICE bool jumpAllowed(const Scene& s, const sim::World& w) {
  return mayJump(s.level, w) && sim::jumpsLeft(s.query, w) > 0;
}

// Returns the likeliest allowed move, the first one on ties.
OBBY_DEVICE int likeliest(const float* logits, bool mayJump) {
  int best = 0;
  for (int m = 1; m < kMoves; ++m) {
    if (!isAllowed(m, mayJump)) continue;
    if (logits[m] > logits[best]) best = m;
  }
  return best;
}

// Draws a move among the allowed ones, with the probabilities of the logits (kMoves). The bits are
// the same for every number of lanes.
template <class F>
OBBY_DEVICE int draw(const float* logits, bool mayJump, Random& random) {
  constexpr int kStep = Lanes<F>::kCount, kPadded = (kMoves + kStep - 1) / kStep * kStep;
  constexpr float kBarred = -0x1.fffffep127f;  // far below all others
  alignas(64) float odds[kPadded];
  for (int m = 0; m < kPadded; ++m) odds[m] = m < kMoves ? logits[m] : kBarred;
  for (int m = 1; m < kMoves && !mayJump; m += 2) odds[m] = kBarred;
  F rows(kBarred), row;
  for (int m = 0; m < kPadded; m += kStep) {
    loadRow(odds + m, row);
    rows = maxf(row, rows);  // maxf() returns the second argument for NaN
  }
  const F max(greatestOf(rows));
  for (int m = 0; m < kPadded; m += kStep) {
    loadRow(odds + m, row);
    storeRow(expOfNegative<F>(row - max), odds + m);
  }
  const int every = mayJump ? 1 : 2;  // the moves in between have no odds
  float sum = 0;
  for (int m = 0; m < kMoves; m += every) sum += odds[m];
  float rest = random.unit() * sum;
  int drawn = 0;
  for (int m = 0; m < kMoves; m += every) {
    drawn = m;
    rest -= odds[m];
    if (rest < 0) break;
  }
  return drawn;
}

}  // namespace obby::policy
