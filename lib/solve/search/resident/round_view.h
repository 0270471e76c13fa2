// What the kernels of a resident search read and write: plain data, one struct for all of them.
#pragma once

#include "solve/search/archive/archive_node.h"
#include "solve/search/guidance/beam_view.h"
#include "solve/search/guidance/potential_view.h"
#include "solve/search/resident/archive_view.h"
#include "solve/search/resident/sum_tree.h"
#include "solve/search/rollouts/rollout_kernel.h"

namespace obby::solve {

// What rollouts bring that the archive lacks, (rollouts, room) each.
struct CandidateView {
  sim::World* worlds;
  sim::LooseBody* loose;  // (rollouts, room, looseCount)
  uint64_t* keys;
  uint32_t* ticks;  // into the rollout
  uint32_t* cells;  // of the archive, or kNone: a new one
  uint32_t* slots;  // of the claims
};

// Who of a round's candidates gets a cell. A table of keys, as the archive's.
struct ClaimView {
  uint64_t* keys;        // 0: free
  uint64_t* ranks;       // the least arrival rank
  uint32_t* candidates;  // the first of those with that rank
  uint32_t* shared;      // not 0: candidates of several rollouts
  uint32_t slotMask;
};

struct ResidentEnd {
  Approach closest;
  Vec3 position;          // feet
  uint32_t closestTicks;  // into the rollout, as those below
  uint32_t ticks;
  uint32_t wayTicks;  // to the end of the attempt: a fall goes on after the rollout
  uint32_t parent;    // node of the start
  uint32_t part;
  uint32_t candidates;
  sim::Outcome outcome;
};

struct GoalReached {
  uint64_t rank;  // of the arrival
  uint32_t rollout, parent, ticks;
};

// A way that the host has played: the visits are its candidates.
struct PlayedWay {
  sim::World end;
  RolloutPath path;
  uint32_t visits;
};

// What a round comes to, in numbers.
struct RoundReport {
  uint64_t steps;
  uint64_t closest;         // closestRank
  uint32_t closestRollout;  // the first of those
  uint32_t candidates, goals;
  uint32_t lastFinder;     // 1 + the last rollout with a new cell; 0: none
  uint32_t overruns;       // sim::Flag bits
  uint32_t bestPotential;  // bits of the best that the archive ever kept
  uint32_t sightings;      // cells that were found to be passed through by others
};

struct ResidentArguments {
  RolloutRules rules;
  PotentialView potential;
  BeamView beam;
  ArchiveView archive;
  SumTree weights;       // of the cells
  float best;            // potential that the weights are relative to
  uint32_t* rankCounts;  // (kRanks), cells of each rank of the beam
  SumTree rankSums;      // of those
  SumTree bestCells;     // 1 for the beam's cells
  uint32_t beamWidth;    // cells that it has at least, if there are so many
  uint32_t firstBeam;    // the first rollout of the round that starts from one of them
  uint64_t firstRollout;
  uint32_t room;            // candidates of a rollout, at most
  uint32_t freeCells;       // that the archive may still get
  uint32_t firstNode;       // of the round
  uint32_t endParts;        // (outcomes, endParts) counts; the last for no part
  uint32_t* starts;         // (rollouts), cells
  sim::LooseBody* loose;    // (rollouts, looseCount)
  const PlayedWay* played;  // (rollouts), or null
  CandidateView candidates;
  ClaimView claims;
  uint64_t* finds;  // (rollouts), cells that are new << 32 | cells reached better
  SumTree findSums;
  ResidentEnd* ends;    // (rollouts)
  GoalReached* goals;   // (rollouts), in any order
  uint32_t* endCounts;  // (outcomes, endParts)
  Node* nodes;          // of the round
  RoundReport* report;
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
constexpr uint32_t kRanks = 65536, kRankTicks = 8;  // f of the beam, in ranks

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

// The closer, the less: more targets, then less distance. Bits of floats that are not negative are
// in their order.
OBBY_DEVICE uint64_t closestRank(const Approach& a) {
  return uint64_t(~a.targets) << 32 | floatBits(a.distance + 0.0f);
}

}  // namespace obby::solve
