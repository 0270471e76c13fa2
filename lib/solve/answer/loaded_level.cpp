#include "solve/answer/loaded_level.h"

#include <capnp/any.h>

#include "base/stopwatch.h"
#include "base/table_bytes.h"

namespace obby::solve {

PlayerLevels::PlayerLevels() = default;
PlayerLevels::~PlayerLevels() = default;

Result<const LoadedLevel*> PlayerLevels::of(const LoadedLevel& base, const level::Player& player) {
  if (player.isLevels()) return &base;
  if (const auto found = levels_.find(player); found != levels_.end()) {
    return found->second ? found->second.get() : &base;
  }
  io::RecordBuilder changed(base.record.reader());
  OBBY_RETURN_IF_ERROR(level::setPlayer(player, changed.root().getLevel()));
  const auto physics = base.record.reader().getLevel().getPhysics();
  std::unique_ptr<LoadedLevel> made;
  if (capnp::toAny(changed.reader().getLevel().getPhysics()) != capnp::toAny(physics)) {
    OBBY_ASSIGN(LoadedLevel loaded, loadLevel(io::Record(std::move(changed))));
    made = std::make_unique<LoadedLevel>(std::move(loaded));
    bytes_ += bytesOf(*made);
  }
  const LoadedLevel* const level = made ? made.get() : &base;
  levels_.emplace(player, std::move(made));
  return level;
}

Result<LoadedLevel> loadLevel(const io::Record& record) {
  const Stopwatch watch;
  OBBY_ASSIGN(level::Level compiled, level::Level::compile(record.reader().getLevel()));
  return LoadedLevel{record, std::move(compiled), watch.seconds()};
}

uint64_t bytesOf(const LoadedLevel& level) {
  const uint64_t words = level.record.reader().totalSize().wordCount;
  const uint64_t own = words * sizeof(capnp::word) + tableBytes(level.level.view());
  return own + level.players->bytes();
}

}  // namespace obby::solve
