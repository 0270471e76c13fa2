// How the archive remembers the ways to its states. Plain data, for device code.
#pragma once

#include "level/level_view.h"
#include "sim/world.h"

namespace obby::solve {

constexpr uint32_t kNone = level::kNone;

// Streams of random numbers count up from 0; these bits say what a rollout is instead of random.
constexpr uint64_t kKnown = 1ull << 62;      // a way of an earlier answer
constexpr uint64_t kByPolicy = 1ull << 61;   // moves of the policy, drawn from that stream
constexpr uint64_t kLikeliest = 1ull << 60;  // with kByPolicy: its likeliest moves

// How a state was reached: `ticks` ticks of rollout `rollout` from the state of node `parent`.
struct Node {
  uint64_t rollout;  // its stream of random numbers, or with kKnown an index into Problem::known
  uint32_t parent;   // kNone: this is the start
  uint32_t ticks;
};

// Of two arrivals in a cell, or at the goal, the lesser is better: fewer ticks, or as many with
// fewer jumps.
OBBY_DEVICE uint64_t arrivalRank(const sim::World& w) { return uint64_t(w.tick) << 16 | w.jumps; }

}  // namespace obby::solve
