#include "solve/search/selectors/mixed_selector.h"

#include "solve/search/selectors/beam_selector.h"
#include "solve/search/selectors/policy_selector.h"
#include "solve/search/selectors/selection.h"

namespace obby::solve {

void MixedSelector::choose(const Archive& archive, ThreadPool& pool, Random& random,
                           std::span<Choice> choices) {
  const size_t half = (choices.size() + 1) / 2;
  first_->choose(archive, pool, random, choices.first(half));
  if (half < choices.size()) second_->choose(archive, pool, random, choices.subspan(half));
}

void MixedSelector::learn(const Archive& archive, std::span<const Tried> tried) {
  const size_t half = (tried.size() + 1) / 2;
  first_->learn(archive, tried.first(half));
  second_->learn(archive, tried.subspan(half));
}

std::unique_ptr<Selector> makeMixedSelector(const Problem& problem, const ExploreContext& context) {
  return std::make_unique<MixedSelector>(
      policyFirst(hedgedSelector(problem, context), context, kPolicyFrom),
      makeBeamSelector(problem, context));
}

}  // namespace obby::solve
