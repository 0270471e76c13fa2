// A selector chooses the cells of the archive that a round of the search starts from, and how long
// its rollouts are. The search methods differ in their selectors. Host only.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/random.h"
#include "base/thread_pool.h"
#include "solve/model/problem.h"
#include "solve/search/archive/archive.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

// The start of a rollout, its length, and the source of its moves.
struct Choice {
  uint32_t cell;    // cell of the archive
  uint32_t ticks;   // max length, at least 1
  uint64_t by = 0;  // kByPolicy, optionally with kLikeliest; 0: random moves
};

// The result of a rollout.
struct Tried {
  uint32_t cell;       // where it started
  uint32_t firstCell;  // first of the cells that it added to the archive
  uint32_t cells;      // number of added cells, which follow in the order of arrival
  float potential;     // best of the states that the archive kept; 0: it kept none
};

// A search asks for each round's choices, then reports their results. Both calls must depend on
// their arguments alone, never on the number of threads.
class Selector {
 public:
  virtual ~Selector() = default;

  // Sets the cell of every choice, one for each rollout of the round. Their ticks are preset to the
  // max length of a rollout, and may be lowered.
  virtual void choose(const Archive& archive, ThreadPool& pool, Random& random,
                      std::span<Choice> choices) = 0;

  // Learns the results of the choices, in their order, after the archive has taken what they found.
  virtual void learn(const Archive&, std::span<const Tried>) {}
};

// Makes the selector of one search. The context's tables must outlive the selector; the other
// arguments need not.
using MakeSelector = std::unique_ptr<Selector> (*)(const Problem&, const ExploreContext&);

}  // namespace obby::solve
