// Two selectors over one archive, each with half of every round. Each continues from what the other
// finds. A level that misleads one costs at most about twice what the other needs.
#pragma once

#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/selectors/selector.h"

namespace obby::solve {

class MixedSelector : public Selector {
 public:
  MixedSelector(std::unique_ptr<Selector> first, std::unique_ptr<Selector> second)
      : first_(std::move(first)), second_(std::move(second)) {}

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;
  void learn(const Archive& archive, std::span<const Tried> tried) override;

 private:
  std::unique_ptr<Selector> first_, second_;
};

// The policy plays from this round on. Levels solved before it are solved sooner without the
// policy.
constexpr uint32_t kPolicyFrom = 8;

// Combines the hedged selector, with the policy first if there is one, and the beam.
std::unique_ptr<Selector> makeMixedSelector(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
