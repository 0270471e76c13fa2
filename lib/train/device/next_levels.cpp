#include "train/device/next_levels.h"

#include <utility>

namespace obby::train {

void NextLevels::ask(std::vector<Wanted> wanted) {
  wait();
  wanted_ = std::move(wanted);
  if (!wanted_.empty()) maker_ = std::thread([this] { make(); });
}

void NextLevels::make() {
  pool_.run(int(wanted_.size()), [this](int i) {
    const Wanted& w = wanted_[size_t(i)];
    Slot& slot = next_[w.place];
    auto level = source_.level(w.index, w.hardest);
    slot.status = level ? Status() : Status(level.error());
    if (level) slot.next.level = *std::move(level);
  });
  if (brought_) brought_ = bring();
}

// Those that could be made, if the source was not told to stop.
Status NextLevels::bring() {
  std::vector<NextLevel*> made;
  std::vector<const TrainingLevel*> levels;
  for (const Wanted& w : wanted_) {
    Slot& slot = next_[w.place];
    if (!slot.status || !slot.next.level) continue;
    made.push_back(&slot.next);
    levels.push_back(slot.next.level.get());
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
  Slot& slot = next_[place];
  OBBY_RETURN_IF_ERROR(slot.status);
  OBBY_RETURN_IF_ERROR(brought_);
  return std::exchange(slot.next, {});
}

}  // namespace obby::train
