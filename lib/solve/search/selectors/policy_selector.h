// Rollouts by a trained policy: once from each new state (GE-PS), or from the start only.
#pragma once

#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/selectors/selector.h"

namespace obby::solve {

// Selects cells as the inner selector does. The policy explores from a cell when it is first chosen
// since it was found or improved. Once is enough, as the policy plays nearly the same each time.
// Later rollouts are random, and so are all those before round `fromRound`, counted from 1.
class PolicyFirstSelector : public Selector {
 public:
  explicit PolicyFirstSelector(std::unique_ptr<Selector> inner, uint32_t fromRound = 0)
      : inner_(std::move(inner)), fromRound_(fromRound) {}

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;
  void learn(const Archive& archive, std::span<const Tried> tried) override {
    inner_->learn(archive, tried);
  }

 private:
  std::unique_ptr<Selector> inner_;
  uint32_t fromRound_;
  ChunkedVector<uint32_t> explored_;  // (cells), node of the state from which the policy explored
};

// Always selects the start: first with the policy's likeliest moves, then with drawn ones. In the
// first kPatience rounds rollouts last half of their max length.
class PolicyAloneSelector : public Selector {
 public:
  static constexpr uint32_t kPatience = 16;  // rounds

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;

 private:
  uint32_t rounds_ = 0;
};

// Returns `inner` with the context's policy first, or `inner` itself if there is no policy.
std::unique_ptr<Selector> policyFirst(std::unique_ptr<Selector> inner,
                                      const ExploreContext& context, uint32_t fromRound = 0);

// Makes the selector of GE-PS as published: plain Go-Explore with the policy first.
std::unique_ptr<Selector> makePolicyFirstSelector(const Problem& problem,
                                                  const ExploreContext& context);
std::unique_ptr<Selector> makePolicyAloneSelector(const Problem& problem,
                                                  const ExploreContext& context);

// Settings for rollouts of two minutes.
GoExploreSettings aloneSettings();

}  // namespace obby::solve
