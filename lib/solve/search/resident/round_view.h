// Plain data that the kernels of a resident search read and write. One struct serves all of them.
#pragma once

#include "solve/search/archive/archive_node.h"
#include "solve/search/guidance/beam_view.h"
#include "solve/search/guidance/potential_view.h"
#include "solve/search/resident/archive_view.h"
#include "solve/search/resident/sum_tree.h"
#include "solve/search/rollouts/rollout_kernel.h"

namespace obby::solve {

// States of rollouts that the archive would keep, (rollouts, capacity) each.
struct CandidateView {
  sim::World* worlds;
  sim::RigidBody* bodies;  // (rollouts, capacity, bodyCount)
  uint64_t* keys;
  uint32_t* ticks;  // ticks into the rollout
  uint32_t* cells;  // cells of the archive; kNone: a new one
  uint32_t* slots;  // slots of the claims
};

// Decides which of a round's candidates gets a cell. It is a hash table of keys, like the
// archive's.
struct ClaimView {
  uint64_t* keys;        // 0: free
  uint64_t* ranks;       // lowest arrival rank
  uint32_t* candidates;  // first candidate with that rank
  uint32_t* shared;      // not 0: several rollouts have candidates for the key
  uint32_t slotMask;
};

struct ResidentEnd {
  Approach closest;
  Vec3 position;          // feet
  uint32_t closestTicks;  // ticks into the rollout, like `ticks` and `pathTicks`
  uint32_t ticks;
  uint32_t pathTicks;  // ticks to the end of the attempt; a fall goes on after the rollout
  uint32_t parent;     // node of the start
  uint32_t part;
  uint32_t candidates;
  sim::Outcome outcome;
};

struct GoalReached {
  uint64_t rank;  // arrival rank
  uint32_t rollout, parent, ticks;
};

// A trajectory that the host has played. Its visits are its candidates.
struct PlayedStart {
  sim::World end;
  RolloutPath path;
  uint32_t visits;
};

// Counts and best values of a round.
struct RoundReport {
  uint64_t steps;
  uint64_t closest;         // closestRank()
  uint32_t closestRollout;  // the first with that rank
  uint32_t candidates, goals;
  uint32_t lastFinder;     // 1 + the last rollout with a new cell; 0: none
  uint32_t overruns;       // sim::Flag bits
  uint32_t bestPotential;  // bits of the best potential ever kept
  uint32_t sightings;      // cells that were marked as sighted
};

// Selects the cells that a round starts from.
struct RoundSelection {
  SumTree weights;       // selection weights of the cells
  float best;            // potential that the weights are relative to
  uint32_t* rankCounts;  // (kRanks), number of cells of each beam rank
  SumTree rankSums;      // sums of rankCounts
  SumTree bestCells;     // 1 for the beam's cells
  uint32_t beamWidth;    // min number of cells in the beam, if the archive has that many
  uint32_t firstBeam;    // first rollout of the round that starts from the beam
  uint32_t* starts;      // (rollouts), cells
};

// Results of a round.
struct RoundResults {
  uint64_t* finds;  // (rollouts), number of new cells << 32 | number of improved cells
  SumTree findSums;
  ResidentEnd* ends;    // (rollouts)
  GoalReached* goals;   // (rollouts), in any order
  uint32_t* endCounts;  // (outcomes, endParts)
  uint32_t endParts;    // columns of endCounts; the last is for no part
  Node* nodes;          // new nodes of the round
  RoundReport* report;
};

struct ResidentArguments : RoundSelection, RoundResults {
  RolloutRules rules;
  PotentialView potential;
  BeamView beam;
  ArchiveView archive;
  uint64_t firstRollout;
  uint32_t capacity;          // max candidates of a rollout
  uint32_t freeCells;         // cells that the archive may still add
  uint32_t firstNode;         // first new node of the round
  sim::RigidBody* bodies;     // (rollouts, bodyCount)
  const PlayedStart* played;  // (rollouts), or null
  CandidateView candidates;
  ClaimView claims;
};

struct SumArguments {
  SumTree tree;
  uint32_t level;
};

struct RehashArguments {
  ArchiveView archive;
  const CellSlot* slots;
};

constexpr uint32_t kOutcomes = 9;
constexpr uint32_t kRanks = 65536, kRankTicks = 8;  // ranks of the beam, and ticks of f per rank

OBBY_DEVICE uint32_t floatBits(float v) {
  uint32_t bits = 0;
  __builtin_memcpy(&bits, &v, sizeof bits);
  return bits;
}
OBBY_DEVICE float floatOf(uint32_t bits) {
  float v = 0;
  __builtin_memcpy(&v, &bits, sizeof v);
  return v;
}

// Returns a rank that is lower for a closer approach: more targets, then less distance. The bits of
// floats that are not negative sort like the floats.
OBBY_DEVICE uint64_t closestRank(const Approach& a) {
  return uint64_t(~a.targets) << 32 | floatBits(a.distance + 0.0f);
}

}  // namespace obby::solve
