// Which cells of the archive a round of the search starts from, and how long its rollouts are: what
// the search methods differ in. Host only.
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

// Where a rollout starts.
struct Choice {
  uint32_t cell;    // of the archive
  uint32_t ticks;   // its length at most; at least 1
  uint64_t by = 0;  // kByPolicy, with kLikeliest or without: whose moves; 0: random
};

// What came of a rollout.
struct Tried {
  uint32_t cell;       // where it started
  uint32_t firstCell;  // the cells that it added to the archive: firstCell, firstCell + 1, ... in
  uint32_t cells;      //   the order in which it came to them
  float potential;     // the best of what the archive kept of it; 0: it kept nothing
};

// A search asks for each round's choices, then tells what came of them. Both must follow from the
// arguments alone, never from the number of threads.
class Chooser {
 public:
  virtual ~Chooser() = default;

  // Sets the cell of every choice: one for each rollout of the round. Their ticks are set to the
  // longest that a rollout may be, and may be lowered.
  virtual void choose(const Archive& archive, ThreadPool& pool, Random& random,
                      std::span<Choice> choices) = 0;

  // (choices), in their order, once the archive has taken what they found.
  virtual void learn(const Archive&, std::span<const Tried>) {}
};

// Makes the chooser of one search. The context's tables outlive it, the other arguments need not.
using MakeChooser = std::unique_ptr<Chooser> (*)(const Problem&, const ExploreContext&);

}  // namespace obby::solve
