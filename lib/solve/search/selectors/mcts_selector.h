// Monte-Carlo tree search (UCT) whose moves are rollouts. The tree consists of the archive's cells,
// each a child of the cell it was found from. A rollout starts where a descent by UCB1 ends. Its
// reward is the potential of the best state that it found. Host only.
#pragma once

#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/selectors/selector.h"

namespace obby::solve {

GoExploreSettings mctsSettings();

class MctsSelector : public Selector {
 public:
  MctsSelector() { addNode(kNone); }  // the start: earlier answers are learned before any choice

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;
  void learn(const Archive& archive, std::span<const Tried> tried) override;

 private:
  // An option at a node: a rollout from it, or a child.
  struct Arm {
    uint64_t reward = 0;  // sum of potentials * kRewardScale
    uint32_t visits = 0;  // counted when chosen, so pending ones are a virtual loss
  };
  struct TreeNode {
    uint32_t parent, firstChild, nextSibling;  // cells, or kNone
    Arm below;                                 // all visits of the subtree, including own
    Arm own;                                   // rollouts from here
  };
  void addNode(uint32_t parent);
  uint32_t descend();
  uint32_t bestChild(const TreeNode& node) const;
  double score(const Arm& arm, double logVisits) const;

  ChunkedVector<TreeNode> nodes_;  // (cells)
  double best_ = 1;                // best potential of all cells ever, * kRewardScale
};

std::unique_ptr<Selector> makeMctsSelector(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
