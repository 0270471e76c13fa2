// Finds ladders made of parts: thin bars one above the other. The engine's own rule is not
// published. This one is a guess, and the evidence says so.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "import/roles/role.h"

namespace obby::importer {
namespace {

constexpr float kThickest = 2, kDeepest = 2;   // studs: rung height, shorter side
constexpr float kNarrowest = 1, kWidest = 12;  // studs: the longer horizontal side
constexpr float kMinGap = 0.3f, kMaxGap = 3;   // studs: vertical gap between rungs
constexpr float kAside = 0.75f;                // max horizontal studs from one rung to the next
constexpr size_t kFewest = 3;                  // min rungs of a ladder

struct Bar {
  PartDraft* part;
  Box box;
  Vec3 center() const { return part->pose.position; }
};

bool isBar(const PartDraft& part, const Box& box) {
  const Vec3 size = box.hi - box.lo;
  const float across = std::min(size.x, size.z), along = std::max(size.x, size.z);
  const bool plain = part.solid && part.anchored && !part.motion && !part.kill && !part.vanish;
  return plain && part.shape != Shape::truss && size.y <= kThickest && across <= kDeepest &&
         along >= kNarrowest && along <= kWidest;
}

bool isOver(const Bar& low, const Bar& high) {
  const Vec3 d = high.center() - low.center();
  return d.y > 0 && std::hypot(d.x, d.z) <= kAside;
}

// Returns true if `high` is the next bar above `low`.
bool isNext(const Bar& low, const Bar& high) {
  const Vec3 a = low.box.hi - low.box.lo, b = high.box.hi - high.box.lo;
  const float gap = high.box.lo.y - low.box.hi.y;
  const bool alike = std::fabs(a.x - b.x) <= 0.5f * std::max(a.x, b.x) &&
                     std::fabs(a.z - b.z) <= 0.5f * std::max(a.z, b.z);
  return gap >= kMinGap && gap <= kMaxGap && alike;
}

// The bars above each square of ground, lowest first.
using Columns = std::map<std::pair<int, int>, std::vector<Bar>>;

std::pair<int, int> columnOf(Vec3 p) { return {int(std::floor(p.x)), int(std::floor(p.z))}; }

// Returns the next rung above, or null if there is none.
const Bar* nextAbove(const Columns& columns, const Bar& bar) {
  const auto [x, z] = columnOf(bar.center());
  const Bar* best = nullptr;
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dz = -1; dz <= 1; ++dz) {
      const auto column = columns.find({x + dx, z + dz});
      if (column == columns.end()) continue;
      const std::vector<Bar>& bars = column->second;
      // A bar with a higher centre begins at most one rung's height below this centre.
      const float from = bar.center().y - kThickest;
      auto other = std::lower_bound(bars.begin(), bars.end(), from,
                                    [](const Bar& b, float height) { return b.box.lo.y < height; });
      for (; other != bars.end() && other->box.lo.y <= bar.box.hi.y + kMaxGap; ++other) {
        const bool lower = best == nullptr || other->center().y < best->center().y;
        if (lower && isOver(bar, *other)) best = &*other;
      }
    }
  }
  return best != nullptr && isNext(bar, *best) ? best : nullptr;
}

Columns columnsOf(LevelDraft& level) {
  Columns columns;
  for (PartDraft& part : level.parts) {
    const Box box = boundsOf(part.pose, part.size * 0.5f);
    if (isBar(part, box)) columns[columnOf(part.pose.position)].push_back({&part, box});
  }
  for (auto& [square, bars] : columns) {
    std::stable_sort(bars.begin(), bars.end(),
                     [](const Bar& a, const Bar& b) { return a.box.lo.y < b.box.lo.y; });
  }
  return columns;
}

}  // namespace

void ladderFromStacks(RoleContext& context) {
  const Columns columns = columnsOf(context.level);
  for (const auto& [square, bars] : columns) {
    for (const Bar& lowest : bars) {
      if (lowest.part->climbable) continue;  // part of a ladder that begins lower
      std::vector<PartDraft*> rungs;
      for (const Bar* bar = &lowest; bar != nullptr; bar = nextAbove(columns, *bar)) {
        rungs.push_back(bar->part);
      }
      if (rungs.size() < kFewest) continue;
      for (PartDraft* rung : rungs) {
        if (rung->climbable) break;
        rung->climbable = true;
        rung->evidence.push_back(
            {"ladder", fmt::format("{} thin parts one above the other", rungs.size()), true});
      }
    }
  }
}

}  // namespace obby::importer
