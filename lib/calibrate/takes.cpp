#include "calibrate/takes.h"

#include <fmt/format.h>

#include "calibrate/surroundings.h"
#include "io/text.h"

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
                 fmt::format("there is no level '{}' before this recording", track.level),
                 "put the level of this recording before it"};
  const auto record = level->second.reader().getLevel();
  OBBY_ASSIGN(const level::Level compiled, level::Level::compile(record));
  OBBY_RETURN_IF_ERROR(place(track, record, compiled));
  track.name = unlike(track.name);
  lookForStrays(track, compiled);
  takes_.push_back({std::move(track), level->second});
  return {};
}

// Numbers repeated manoeuvres: "hold jump", "hold jump (2)".
std::string Takes::unlike(const std::string& name) {
  uint32_t& number = numbers_[name];
  for (;;) {
    ++number;
    const std::string out = number == 1 ? name : fmt::format("{} ({})", name, number);
    if (names_.insert(out).second) return out;
  }
}

void Takes::lookForStrays(const Track& track, const level::Level& level) {
  for (const Stray& stray : straysOf(track, level.view())) {
    Astray& a = astray_[{track.level, stray.number}];
    ++a.recordings;
    if (stray.studs <= a.studs) continue;
    a.studs = stray.studs;
    a.recording = track.name;
    const std::string& name = level.partName(stray.number);
    const bool same = stray.part.find(name) != std::string::npos;
    a.part = same ? stray.part : fmt::format("{} ({})", stray.part, name);
  }
}

std::vector<std::string> Takes::warnings() const {
  std::vector<std::string> out;
  for (const auto& [where, a] : astray_) {
    const std::string more =
        a.recordings == 1 ? "" : ", and less in " + io::plural(a.recordings - 1, "other recording");
    out.push_back(fmt::format(
        "level '{}': no start time from 0 to {} seconds makes '{}' move as recorded: it is {:.2g} "
        "studs off in recording '{}'{} (record its motion and import the level again, or leave "
        "these "
        "recordings out)",
        where.first, kLongestClock, a.part, a.studs, a.recording, more));
  }
  return out;
}

std::vector<Take> holdOut(std::vector<Take>& takes, uint32_t n) {
  std::vector<Take> kept, out;
  for (size_t i = 0; i < takes.size(); ++i)
    ((i + 1) % n == 0 ? out : kept).push_back(std::move(takes[i]));
  takes = std::move(kept);
  return out;
}

}  // namespace obby::calibrate
