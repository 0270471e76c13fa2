// Sizes are estimates of the base64 text. Thinning reduces the attempts' ticks first, then moving
// parts' ticks, then whole attempts. It never touches solutions.
#include "view/budget.h"

#include <fmt/format.h>

#include <algorithm>

#include "view/tracks.h"

namespace obby::view {
namespace {

constexpr uint32_t kMaxStride = 8;
// Max stride of moving parts, for pages that no browser could open otherwise.
constexpr uint32_t kCoarsest = 64;
constexpr uint32_t kMinSeconds = 20;      // min motion in a page, if no trajectory is longer
constexpr uint32_t kMaxSeconds = 600;     // max motion in a page
constexpr size_t kSampleBytes = 20;       // position, yaw, state in base64
constexpr size_t kRunBytes = 8;           // one run of equal actions
constexpr size_t kEventBytes = 18;        // one part that appears, disappears or starts to move
constexpr size_t kTrajectoryBytes = 300;  // names and numbers of a trajectory
constexpr size_t kPartBytes = 70;         // a part in columns, and around its name
constexpr size_t kVertexBytes = 16;       // per vertex of a hull
constexpr size_t kEvidenceBytes = 16;     // JSON around its text

uint32_t maxTicksShown(const LevelEntry& level) {
  return kMaxSeconds * level.level->view().params.controlRate;
}

size_t base64Size(size_t bytes) { return (bytes + 2) / 3 * 4; }

size_t attemptsSize(const PageSizes& sizes, const Budget& b) {
  return (sizes.attempts / b.attemptStride + sizes.whole) / b.attemptsOneOf;
}

size_t total(const PageSizes& sizes, const Budget& b) {
  return sizes.fixed + attemptsSize(sizes, b) + sizes.tracks / b.trackStride;
}

size_t sizeOf(schema::Part::Reader part) {
  size_t bytes = kPartBytes + std::max(part.getSource().getPath().size(), part.getName().size());
  for (const auto item : part.getEvidence()) {
    bytes += item.getRole().size() + item.getReason().size() + kEvidenceBytes;
  }
  for (const auto hull : part.getHulls()) bytes += hull.getVertices().size() * kVertexBytes;
  return bytes;
}

}  // namespace

uint32_t minTicksShown(const LevelEntry& level) {
  return kMinSeconds * level.level->view().params.controlRate;
}

std::vector<uint32_t> ticksShown(const Report& report) {
  std::vector<uint32_t> ticks;
  for (const LevelEntry& level : report.levels) ticks.push_back(minTicksShown(level));
  for (const QueryEntry& query : report.queries) {
    if (query.level < 0) continue;
    const LevelEntry& level = report.levels[size_t(query.level)];
    uint64_t last = 0;
    // Without a selected trajectory the page shows the level at the query's start.
    if (query.query) {
      last = uint64_t(query.reader().getStart().getTick()) + minTicksShown(level);
    }
    for (const PathEntry& path : query.paths) {
      if (!path.played()) continue;
      last = std::max(last, uint64_t(path.inLevelTicks().getStartTick()) + path.playback.ticks());
    }
    // Later times wrap around where the motion repeats.
    uint32_t& shown = ticks[size_t(query.level)];
    shown = std::max(shown, uint32_t(std::min<uint64_t>(last, maxTicksShown(level))));
  }
  return ticks;
}

void PageSizes::add(const LevelEntry& level, uint32_t ticks) {
  for (const auto part : level.reader().getParts()) fixed += sizeOf(part);
  forTracks(level.level->view(), ticks, 1, [&](const Track& track) {
    tracks += base64Size(track.bytes());
    longMotion = longMotion || (track.cut && ticks >= maxTicksShown(level));
  });
}

void PageSizes::add(const QueryEntry& query) {
  if (query.result) fixed += query.answer().totalSize().wordCount * 8;
  for (const PathEntry& path : query.paths) {
    const bool attempt = path.kind == PathKind::attempt;
    (attempt ? attempts : fixed) += path.playback.feet.size() * kSampleBytes;
    size_t& rest = attempt ? whole : fixed;
    rest += kTrajectoryBytes + path.inLevelTicks().getActions().size() * kRunBytes;
    rest += (path.playback.events.size() + path.playback.motions.size()) * kEventBytes;
    for (const BodyTrack& track : path.playback.bodies) rest += base64Size(track.bytes());
  }
}

Budget budgetFor(const Report& report, size_t target) {
  PageSizes sizes;
  const std::vector<uint32_t> ticks = ticksShown(report);
  for (size_t i = 0; i < report.levels.size(); ++i) sizes.add(report.levels[i], ticks[i]);
  for (const QueryEntry& query : report.queries) sizes.add(query);
  return budgetFor(sizes, target);
}

Budget budgetFor(const PageSizes& sizes, size_t target, Budget min) {
  Budget b = std::move(min);
  b.notes.clear();
  while (total(sizes, b) > target && b.attemptStride < kMaxStride) b.attemptStride *= 2;
  while (total(sizes, b) > target && b.trackStride < kMaxStride) b.trackStride *= 2;
  while (total(sizes, b) > target && attemptsSize(sizes, b) > target / 8) b.attemptsOneOf *= 2;
  const size_t max = std::max(target, kPageLimit);
  while (total(sizes, b) > max && b.trackStride < kCoarsest) b.trackStride *= 2;
  if (b.attemptStride > 1) {
    b.notes.push_back(
        fmt::format("To keep the page small, failed attempts are drawn at one tick in {} only. "
                    "--full keeps all.",
                    b.attemptStride));
  }
  if (b.trackStride > 1) {
    b.notes.push_back(fmt::format(
        "To keep the page small, moving parts are drawn at one tick in {} only. --full keeps all.",
        b.trackStride));
  }
  if (sizes.longMotion) {
    b.notes.push_back("Motion is shown for ten minutes. Parts that move for longer stop there.");
  }
  if (b.attemptsOneOf > 1) {
    b.notes.push_back(
        fmt::format("One failed attempt in {} is shown. --full keeps all.", b.attemptsOneOf));
  }
  return b;
}

}  // namespace obby::view
