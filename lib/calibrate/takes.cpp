#include "calibrate/takes.h"

#include <fmt/format.h>

#include "calibrate/surroundings.h"

namespace obby::calibrate {

Result<io::Then> Takes::handle(const io::Record& record) {
  switch (record.which()) {
    case io::Kind::LEVEL: {
      const auto level = record.reader().getLevel();
      OBBY_RETURN_IF_ERROR(level::Level::compile(level));
      levels_.insert_or_assign(level.getName(), record);
      return io::Then::drop;
    }
    case io::Kind::RECORDING:
      OBBY_RETURN_IF_ERROR(add(record.reader().getRecording()));
      return io::Then::drop;
    default: return io::Then::pass;
  }
}

Status Takes::add(schema::Recording::Reader recording) {
  OBBY_ASSIGN(Track track, trackOf(recording));
  const auto level = levels_.find(track.level);
  if (level == levels_.end())
    return Error{{},
                 {},
                 "level",
                 fmt::format("there is no level '{}' before", track.level),
                 "give the level that it was recorded in, too"};
  const auto record = level->second.reader().getLevel();
  OBBY_ASSIGN(const level::Level compiled, level::Level::compile(record));
  OBBY_RETURN_IF_ERROR(place(track, record, compiled));
  takes_.push_back({std::move(track), level->second});
  return {};
}

std::vector<Take> holdOut(std::vector<Take>& takes, uint32_t n) {
  std::vector<Take> kept, out;
  for (size_t i = 0; i < takes.size(); ++i)
    ((i + 1) % n == 0 ? out : kept).push_back(std::move(takes[i]));
  takes = std::move(kept);
  return out;
}

}  // namespace obby::calibrate
