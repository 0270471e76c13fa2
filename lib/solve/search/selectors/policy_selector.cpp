#include "solve/search/selectors/policy_selector.h"
#include "solve/search/selectors/selection.h"

#include <algorithm>

namespace obby::solve {

void PolicyFirstSelector::choose(const Archive& archive, ThreadPool& pool, Random& random,
                                 std::span<Choice> choices) {
  inner_->choose(archive, pool, random, choices);
  if (archive.epoch() < fromRound_) return;
  explored_.resize(archive.cellCount(), kNone);
  for (Choice& c : choices) {
    const uint32_t node = archive.node(c.cell);
    if (explored_[c.cell] == node) continue;
    explored_[c.cell] = node;
    c.by = kByPolicy;
  }
}

void PolicyAloneSelector::choose(const Archive&, ThreadPool&, Random&, std::span<Choice> choices) {
  const uint32_t shorter = rounds_ < kPatience ? 2 : 1;
  for (Choice& c : choices) {
    c.cell = 0;
    c.ticks = std::max(c.ticks / shorter, 1u);
    c.by = kByPolicy;
  }
  if (rounds_++ == 0) choices.front().by |= kLikeliest;
}

std::unique_ptr<Selector> policyFirst(std::unique_ptr<Selector> inner,
                                      const ExploreContext& context, uint32_t fromRound) {
  if (!context.pilot.exists()) return inner;
  return std::make_unique<PolicyFirstSelector>(std::move(inner), fromRound);
}

std::unique_ptr<Selector> makePolicyFirstSelector(const Problem& problem,
                                                  const ExploreContext& context) {
  return policyFirst(plainSelector(problem, context), context);
}

std::unique_ptr<Selector> makePolicyAloneSelector(const Problem& problem,
                                                  const ExploreContext& context) {
  if (!context.pilot.exists()) return plainSelector(problem, context);
  return std::make_unique<PolicyAloneSelector>();
}

GoExploreSettings aloneSettings() {
  GoExploreSettings s;
  s.phaseJumps = 220;
  s.byPolicy = true;
  return s;
}

}  // namespace obby::solve
