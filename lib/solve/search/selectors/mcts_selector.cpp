#include "solve/search/selectors/mcts_selector.h"

#include <algorithm>
#include <bit>

namespace obby::solve {

namespace {

// Exploration constant of UCB1, with rewards of 0 to 1. Of 1/8, 1/4, 1/2, 1 and 1.4 the smaller
// ones did better on levels/.
constexpr double kExploration = 0.125;
constexpr float kRewardScale = 1024;  // integer rewards, so that their sums are exact

// Returns log2 of n > 0 with an error below 0.09. The math library's last bits differ by machine.
double roughLog2(uint32_t n) {
  const int whole = std::bit_width(n | 1) - 1;
  return whole + (double(n) / double(1u << whole) - 1);
}

}  // namespace

GoExploreSettings mctsSettings() { return {}; }

void MctsSelector::addNode(uint32_t parent) {
  const uint32_t cell = uint32_t(nodes_.size());
  nodes_.push_back({parent, kNone, kNone, {}, {}});
  if (parent == kNone) return;
  nodes_[cell].nextSibling = nodes_[parent].firstChild;
  nodes_[parent].firstChild = cell;
}

// An arm that has not been tried comes first.
double MctsSelector::score(const Arm& arm, double logVisits) const {
  if (arm.visits == 0) return 1e9;
  const double n = arm.visits;
  return double(arm.reward) / (n * best_) + kExploration * sqrtf32(float(logVisits / n));
}

// Returns the best child, or kNone for the node itself. On a tie the newest child wins and the node
// itself loses, so the end of a rollout comes before its beginning.
uint32_t MctsSelector::bestChild(const TreeNode& node) const {
  const double logVisits = 0.6931471805599453 * roughLog2(node.below.visits);
  uint32_t best = kNone;
  double max = -1;
  for (uint32_t c = node.firstChild; c != kNone; c = nodes_[c].nextSibling) {
    const double s = score(nodes_[c].below, logVisits);
    if (s <= max) continue;
    max = s;
    best = c;
  }
  return score(node.own, logVisits) > max ? kNone : best;
}

uint32_t MctsSelector::descend() {
  uint32_t at = 0;
  while (true) {
    TreeNode& node = nodes_[at];
    ++node.below.visits;
    const uint32_t next = bestChild(node);
    if (next == kNone) {
      ++node.own.visits;
      return at;
    }
    at = next;
  }
}

void MctsSelector::choose(const Archive& archive, ThreadPool&, Random&, std::span<Choice> choices) {
  best_ = std::max(1.0, double(archive.bestPotential() * kRewardScale));
  for (Choice& c : choices) c.cell = descend();
}

// New cells form a chain, in the order in which the rollout reached them.
void MctsSelector::learn(const Archive&, std::span<const Tried> tried) {
  for (const Tried& t : tried) {
    const uint64_t reward = uint64_t(t.potential * kRewardScale);
    nodes_[t.cell].own.reward += reward;
    for (uint32_t c = t.cell; c != kNone; c = nodes_[c].parent) nodes_[c].below.reward += reward;
    for (uint32_t i = 0; i < t.cells; ++i) addNode(i == 0 ? t.cell : t.firstCell + i - 1);
  }
}

std::unique_ptr<Selector> makeMctsSelector(const Problem&, const ExploreContext&) {
  return std::make_unique<MctsSelector>();
}

}  // namespace obby::solve
