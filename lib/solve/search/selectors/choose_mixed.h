// Two choosers over one archive, each with half of every round: what one finds the other goes on
// from, and a level that misleads one of them costs at most about twice what the other needs.
#pragma once

#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/selectors/chooser.h"

namespace obby::solve {

class MixedChooser : public Chooser {
 public:
  MixedChooser(std::unique_ptr<Chooser> first, std::unique_ptr<Chooser> second)
      : first_(std::move(first)), second_(std::move(second)) {}

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;
  void learn(const Archive& archive, std::span<const Tried> tried) override;

 private:
  std::unique_ptr<Chooser> first_, second_;
};

// The round from which on the policy plays: what is solved before is solved sooner without.
constexpr uint32_t kPolicyFrom = 8;

// The hedged selector, with the policy first where there is one, and the beam.
std::unique_ptr<Chooser> makeMixedChooser(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
