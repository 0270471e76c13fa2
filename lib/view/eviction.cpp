// The collector's limits, and eviction of trajectories beyond them.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "view/budget.h"
#include "view/report.h"

namespace obby::view {
namespace {

constexpr size_t kQueryBytes = 1024;  // fixed cost of a query
constexpr size_t kMotionShare = 8;    // large pages keep about every n-th tick of motion
constexpr size_t kSlack = 8;          // eviction frees this fraction (1 / kSlack) of the budget

size_t bytesOf(const io::Record& record) {
  return size_t(record.reader().totalSize().wordCount) * 8;
}

size_t bytesOf(const std::optional<io::Record>& record) { return record ? bytesOf(*record) : 0; }

}  // namespace

// Returns the cost of a trajectory, ticks.
size_t Collector::costOf(const PathEntry& path, const Playback& playback) const {
  size_t cost = playback.feet.size() + playback.events.size() + playback.motions.size();
  for (const BodyTrack& track : playback.bodies) cost += track.ticks.size();
  return cost + budget_.trajectoryTicks + budget_.runTicks * path.reader().getActions().size();
}

void Collector::keep(PathEntry& path, Playback playback) {
  ticksKept_ += costOf(path, playback);
  path.playback = std::move(playback);
  if (!path.playback.partsCut || std::exchange(cutNoted_, true)) return;
  note(
      fmt::format("In some trajectories parts appear, vanish or start moving more than {} times. "
                  "Later changes are not shown.",
                  kMaxPartEvents));
}

void Collector::forget(PathEntry& path) {
  if (path.played()) ticksKept_ -= costOf(path, path.playback);
  path.playback = {};
}

// Attempts do not evict solutions, and a trajectory larger than the budget evicts nothing.
void Collector::evictFor(size_t cost, PathKind kind) {
  if (cost > budget_.ticks) return;
  dropOldest(cost, PathKind::attempt);
  if (kind == PathKind::solution && !fits(cost)) dropOldest(cost, kind);
}

// Frees more than required, so that this need not run for each trajectory. Trajectories of a
// running search's progress count as attempts. They are evicted last, since the search will soon
// send newer ones.
void Collector::dropOldest(size_t cost, PathKind kind) {
  std::vector<std::tuple<bool, uint64_t, PathEntry*, size_t>>
      trajectories;  // the last element is the index of the trajectory's query
  for (size_t i = 0; i < report_.queries.size(); ++i) {
    QueryEntry& entry = report_.queries[i];
    for (PathEntry& path : entry.paths) {
      const bool alike = (path.kind == PathKind::solution) == (kind == PathKind::solution);
      if (!alike || !path.played()) continue;
      trajectories.emplace_back(path.ofProgress() && !entry.result, path.serial, &path, i);
    }
  }
  std::sort(trajectories.begin(), trajectories.end());
  for (const auto& [runs, serial, path, query] : trajectories) {
    if (fits(cost + budget_.ticks / kSlack)) break;
    forget(*path);
    path->dropped = true;
    thinned_.insert(query);
    ++dropped_;
  }
}

void Collector::sweepDropped() {
  if (thinned_.empty()) return;
  for (const size_t index : std::exchange(thinned_, {})) {
    std::erase_if(report_.queries[index].paths, [](const PathEntry& path) { return path.dropped; });
  }
  std::string text = fmt::format(
      "Dropped {} of the oldest trajectories to stay within the memory budget.", dropped_);
  if (droppedNote_) {
    report_.notes[*droppedNote_] = std::move(text);
    return;
  }
  droppedNote_ = report_.notes.size();
  note(std::move(text));
}

void Collector::weigh(QueryEntry& entry) {
  if (budget_.bytes == SIZE_MAX || std::exchange(entry.weighed, true)) return;
  bytesKept_ -= entry.bytes;
  entry.bytes =
      kQueryBytes + bytesOf(entry.query) + bytesOf(entry.result) + bytesOf(entry.progress);
  bytesKept_ += entry.bytes;
}

// Counts the record and its page data.
void Collector::weigh(const LevelEntry& entry) {
  if (budget_.bytes == SIZE_MAX) return;
  PageSizes sizes;
  sizes.add(entry, minTicksShown(entry));
  bytesKept_ += bytesOf(entry.record) + sizes.fixed + sizes.tracks / kMotionShare;
}

bool Collector::full() {
  if (bytesKept_ <= budget_.bytes) return false;
  if (!std::exchange(fullNoted_, true)) {
    note(
        "The memory budget is full, so later levels, queries and answers are left out. To see "
        "them, show fewer queries with --query, or save the input in a file and view it without "
        "--live.");
  }
  return true;
}

}  // namespace obby::view
