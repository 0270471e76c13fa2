// What a trainer keeps of itself, and how it goes on from there; ranks that must be of one mind.
#include <fmt/format.h>

#include "base/hash.h"
#include "train/state_codec.h"
#include "train/trainer.h"

namespace obby::train {

Result<std::unique_ptr<Trainer>> Trainer::resume(const TrainerSettings& settings,
                                                 const LevelSource& source, ThreadPool& pool,
                                                 Ranks& ranks, TrainerState state) {
  std::unique_ptr<Trainer> trainer(new Trainer(settings, source, pool, ranks));
  OBBY_RETURN_IF_ERROR(ranks.agree(trainer->restore(std::move(state))));
  return trainer;
}

Status Trainer::restore(TrainerState state) {
  const size_t each = groups_.size(), all = each * ranks_.count();
  if (state.crowds.size() != all)
    return makeError(fmt::format("{} crowds, expected {}", state.crowds.size(), all));
  // A stream is read from its beginning: what was played then need not be kept again.
  uint64_t first = ~uint64_t(0);
  for (size_t i = 0; i < each; ++i)
    first =
        std::min(first, groups_[i]->crowd.firstLevelOf(state.crowds[ranks_.number() * each + i]));
  source_.past(first);
  for (size_t i = 0; i < each; ++i) {
    CrowdState& crowd = state.crowds[ranks_.number() * each + i];
    groups_[i]->random = crowd.draws;
    OBBY_RETURN_IF_ERROR(groups_[i]->crowd.restore(std::move(crowd)));
  }
  iterations_ = state.iterations;
  decisions_ = state.decisions;
  solved_ = state.solved;
  hardest_ = state.hardest;
  seen_ = std::move(state.seen);
  ppo_.restore(state.learner);
  refreshNormaliser();
  return {};
}

TrainerState Trainer::state() const {
  TrainerState out{iterations_, decisions_, solved_, hardest_, seen_, ppo_.state(), {}};
  for (const auto& group : groups_) {
    out.crowds.push_back(group->crowd.state());
    out.crowds.back().draws = group->random;
  }
  if (ranks_.count() == 1) return out;
  const std::vector<std::string> all = ranks_.collect(packCrowds(out.crowds));
  for (size_t rank = 1; rank < all.size(); ++rank) unpackCrowds(all[rank], out.crowds);
  return out;
}

// Ranks of another kind of machine may round otherwise; their networks would part unseen.
Status Trainer::sameNetwork() const {
  if (ranks_.count() == 1) return {};
  Weights<float> weights = ppo_.weights();
  uint64_t hash = 0;
  weights.blocks(
      [&](const float* w, size_t count) { hash = hashBytes(w, count * sizeof(float), hash); });
  std::vector<uint64_t> all(ranks_.count());
  ranks_.exchange(&hash, sizeof hash, all.data());
  for (size_t rank = 1; rank < all.size(); ++rank) {
    if (all[rank] != all[0])
      return makeError(fmt::format("the network of rank {} is no longer that of rank 0", rank),
                       "run all ranks on machines of one kind, with the same build");
  }
  return {};
}

}  // namespace obby::train
