// Nodes record how the archive's states were reached. Plain data, for device code.
#pragma once

#include "level/level_view.h"
#include "sim/world.h"

namespace obby::solve {

constexpr uint32_t kNone = level::kNone;

// Random streams count up from 0. These bits mark rollouts that are not random.
constexpr uint64_t kWarmStart = 1ull << 62;  // a known trajectory, for example of an earlier answer
constexpr uint64_t kByPolicy = 1ull << 61;   // moves of the policy, drawn from the random stream
constexpr uint64_t kLikeliest = 1ull << 60;  // with kByPolicy: its likeliest moves

// A state reached by `ticks` ticks of rollout `rollout` from the state of node `parent`.
struct Node {
  uint64_t rollout;  // random stream; with kWarmStart an index into Problem::known
  uint32_t parent;   // kNone: this is the start
  uint32_t ticks;
};

// Returns the rank of an arrival in a cell or at the goal. Lower is better: fewer ticks, and on a
// tie fewer jumps.
OBBY_DEVICE uint64_t arrivalRank(const sim::World& w) { return uint64_t(w.tick) << 16 | w.jumps; }

}  // namespace obby::solve
