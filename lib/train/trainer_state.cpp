// Saves and restores a trainer, and checks that ranks agree.
#include <fmt/format.h>

#include "base/hash.h"
#include "train/state_codec.h"
#include "train/trainer.h"

namespace obby::train {

Result<std::unique_ptr<Trainer>> Trainer::resume(const TrainerSettings& settings,
                                                 const LevelSource& source, ThreadPool& pool,
                                                 Ranks& ranks, TrainerState state) {
  return resume(settings, makeCpuEngine(settings, source, pool, ranks), ranks, std::move(state));
}

Result<std::unique_ptr<Trainer>> Trainer::resume(const TrainerSettings& settings,
                                                 std::unique_ptr<Engine> engine, Ranks& ranks,
                                                 TrainerState state) {
  std::unique_ptr<Trainer> trainer(new Trainer(settings, std::move(engine), ranks));
  OBBY_RETURN_IF_ERROR(ranks.agree(trainer->restore(std::move(state))));
  return trainer;
}

Status Trainer::restore(TrainerState state) {
  const size_t each = settings_.envGroups, all = each * ranks_.count();
  if (state.envGroups.size() != all)
    return makeError(
        fmt::format("the checkpoint has {} env groups, expected {}", state.envGroups.size(), all));
  OBBY_RETURN_IF_ERROR(engine_->restore(
      state.learner, std::span(state.envGroups).subspan(ranks_.number() * each, each)));
  iterations_ = state.iterations;
  decisions_ = state.decisions;
  solved_ = state.solved;
  hardest_ = state.hardest;
  seen_ = std::move(state.seen);
  refreshNormaliser();
  return takeParameters();
}

Result<TrainerState> Trainer::state() const {
  TrainerState out{iterations_, decisions_, solved_, hardest_, seen_, {}, {}};
  OBBY_ASSIGN(out.learner, ranks_.agree(engine_->learner()));
  OBBY_ASSIGN(out.envGroups, ranks_.agree(engine_->envGroups()));
  if (ranks_.count() == 1) return out;
  const std::vector<std::string> all = ranks_.collect(packEnvGroups(out.envGroups));
  for (size_t rank = 1; rank < all.size(); ++rank) unpackEnvGroups(all[rank], out.envGroups);
  return out;
}

// Returns an error if the network is not finite: its files could replace good ones and would be
// unreadable.
Status Trainer::stillFinite() const {
  if (finite_ && isFinite(seen_)) return {};
  return makeError(
      "training diverged: the network's weights are no longer finite",
      "start again with a lower --learning-rate; resuming the last checkpoint would diverge again");
}

// Checks that all ranks have the same network. On another kind of machine rounding may differ, and
// networks would diverge unnoticed.
Status Trainer::sameNetwork() const {
  if (ranks_.count() == 1) return {};
  const uint64_t hash = hashBytes(parameters_.data(), parameters_.size() * sizeof(float));
  std::vector<uint64_t> all(ranks_.count());
  ranks_.exchange(&hash, sizeof hash, all.data());
  for (size_t rank = 1; rank < all.size(); ++rank) {
    if (all[rank] != all[0])
      return makeError(fmt::format("the network of rank {} differs from that of rank 0", rank),
                       "run all ranks with the same build on machines of the same type");
  }
  return {};
}

}  // namespace obby::train
