// Two selectors over one archive, each with half of every round. Each continues from what the other
// finds. A level that misleads one costs at most about twice what the other needs.
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

// The policy plays from this round on. Levels solved before it are solved sooner without the
// policy.
constexpr uint32_t kPolicyFrom = 8;

// Combines the hedged selector, with the policy first if there is one, and the beam.
std::unique_ptr<Chooser> makeMixedChooser(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
