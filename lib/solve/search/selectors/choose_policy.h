// Rollouts by a trained policy: once from each state that is new (GE-PS), or from the start only.
#pragma once

#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/selectors/chooser.h"

namespace obby::solve {

// Chooses as another does. The first time that a cell is chosen since it was found or improved the
// policy explores from it: as it plays nearly alike each time, once is enough. Later, and wherever
// there is no policy, exploration is random. So it is before round `fromRound`,
// counted from 1.
class PolicyFirstChooser : public Chooser {
 public:
  explicit PolicyFirstChooser(std::unique_ptr<Chooser> inner, uint32_t fromRound = 0)
      : inner_(std::move(inner)), fromRound_(fromRound) {}

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;
  void learn(const Archive& archive, std::span<const Tried> tried) override {
    inner_->learn(archive, tried);
  }

 private:
  std::unique_ptr<Chooser> inner_;
  uint32_t fromRound_;
  ChunkedVector<uint32_t> explored_;  // (cells), node of the state that the policy explored from
};

// Always the start: first the policy's likeliest moves, then drawn ones. Rollouts last half of what
// they may at first, all of it once some rounds have not solved it.
class PolicyAloneChooser : public Chooser {
 public:
  static constexpr uint32_t kPatience = 16;  // rounds

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;

 private:
  uint32_t rounds_ = 0;
};

// `inner` with the context's policy first, or as it is where there is none.
std::unique_ptr<Chooser> policyFirst(std::unique_ptr<Chooser> inner, const ExploreContext& context,
                                     uint32_t fromRound = 0);

// GE-PS of the paper: its Go-Explore, with the policy first.
std::unique_ptr<Chooser> makePolicyFirstChooser(const Problem& problem,
                                                const ExploreContext& context);
std::unique_ptr<Chooser> makePolicyAloneChooser(const Problem& problem,
                                                const ExploreContext& context);

// Rollouts of two minutes.
GoExploreSettings aloneSettings();

}  // namespace obby::solve
