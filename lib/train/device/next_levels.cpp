#include "train/device/next_levels.h"

#include <utility>

namespace obby::train {

void NextLevels::ask(std::vector<Wanted> wanted) {
  wait();
  wanted_ = std::move(wanted);
  if (!wanted_.empty()) maker_ = std::thread([this] { make(); });
}

void NextLevels::make() {
  try {
    makeAll();
  } catch (...) {
    thrown_ = std::current_exception();
  }
}

void NextLevels::makeAll() {
  pool_.run(int(wanted_.size()), [this](int i) {
    const Wanted& w = wanted_[size_t(i)];
    NextLevel& next = next_[w.place];
    auto level = source_.level(w.index, w.hardest);
    next.said = level ? Status() : Status(level.error());
    if (level) next.level = *std::move(level);
  });
  if (brought_) brought_ = bring();
}

// Uploads the levels that the source returned.
Status NextLevels::bring() {
  std::vector<NextLevel*> made;
  std::vector<const TrainingLevel*> levels;
  for (const Wanted& w : wanted_) {
    NextLevel& next = next_[w.place];
    if (!next.level) continue;
    made.push_back(&next);
    levels.push_back(next.level.get());
  }
  if (made.empty()) return {};
  OBBY_ASSIGN(const Delivery delivery,
              deliver(device_, levels, settings_.patience, settings_.worlds, pool_));
  for (size_t i = 0; i < made.size(); ++i) {
    made[i]->place = delivery.places[i];
    made[i]->memory = delivery.memory;
  }
  return {};
}

Result<NextLevel> NextLevels::take(size_t place) {
  wait();
  if (thrown_) std::rethrow_exception(thrown_);
  OBBY_RETURN_IF_ERROR(brought_);
  return std::exchange(next_[place], {});
}

}  // namespace obby::train
