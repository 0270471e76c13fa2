#include "view/entries.h"

#include <fmt/format.h>

#include <algorithm>

namespace obby::view {

schema::Trajectory::Reader PathEntry::reader() const {
  if (!ofProgress()) return record.reader().getTrajectory();
  const auto progress = record.reader().getProgress();
  switch (kind) {
    case PathKind::solution: return progress.getSolution();
    case PathKind::closest: return progress.getBest();
    case PathKind::newest: return progress.getNewest();
    default: return progress.getDeaths()[death];
  }
}

bool QueryEntry::mismatch() const {
  return std::any_of(paths.begin(), paths.end(), [](const PathEntry& path) {
    return path.kind == PathKind::solution && !path.playback.mismatch.empty();
  });
}

std::string Report::title() const {
  if (levels.empty()) return "obby report";
  std::string title = levels.front().level->name();
  if (title.empty()) title = "Level";
  if (levels.size() > 1) title += fmt::format(" and {} more", levels.size() - 1);
  return title;
}

}  // namespace obby::view
