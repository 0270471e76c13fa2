#include "solve/improve/splice.h"

#include <algorithm>
#include <optional>

#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

namespace {

constexpr float kMeetReach = 1.5f;       // studs within which two players stand at the same place
constexpr uint32_t kGraftDraws = 8;      // spans that are drawn
constexpr uint32_t kMinGraft = 12;       // ticks of a span
constexpr uint32_t kGraftDoublings = 6;  // spans of 12 to 384 ticks
constexpr uint32_t kStandStride = 2;     // ticks
constexpr double kMinSaving = 0.01;      // seconds

// Returns the tick from `from` on at which the player stands nearest to `feet`, or -1 if it is
// never within kMeetReach.
int32_t nearestStand(const Line& line, Vec3 feet, uint32_t from) {
  int32_t best = -1;
  float least = kMeetReach * kMeetReach;
  for (uint32_t t = from; t <= line.ticks(); t += kStandStride) {
    const Vec3 to = line.worlds[t].position - feet;
    const float distance = dot(to, to);
    if (distance >= least || !grounded(line.worlds[t])) continue;
    least = distance;
    best = int32_t(t);
  }
  return best;
}

// Ticks `from` to `to` of a donor, which replace ticks `begin` to `end` of the line.
struct Graft {
  uint32_t from, to, begin, end;
};

std::optional<Graft> drawGraft(const Line& line, const Line& donor, Random& random) {
  const uint32_t from = random.below(donor.ticks());
  const uint32_t to = std::min(from + (kMinGraft << random.below(kGraftDoublings)), donor.ticks());
  const bool isLast = to == donor.ticks();
  if (!grounded(donor.worlds[from]) || (!isLast && !grounded(donor.worlds[to])))
    return std::nullopt;
  const int32_t begin = nearestStand(line, donor.worlds[from].position, 0);
  if (begin < 0) return std::nullopt;
  const int32_t end = isLast ? int32_t(line.ticks())
                             : nearestStand(line, donor.worlds[to].position, uint32_t(begin));
  if (end < 0) return std::nullopt;
  return Graft{from, to, uint32_t(begin), uint32_t(end)};
}

}  // namespace

bool splice(const Line& line, const GuidedLines& donors, Variation& variation, Random& random) {
  const GuidedLine& donor = *donors[random.below(uint32_t(donors.size()))];
  const auto costOf = [](const Line& of, uint32_t from, uint32_t to) {
    return of.costs[to].cost - of.costs[from].cost;
  };
  for (uint32_t draw = 0; draw < kGraftDraws; ++draw) {
    const std::optional<Graft> g = drawGraft(line, donor.line, random);
    if (!g) continue;
    const double saved = costOf(line, g->begin, g->end) - costOf(donor.line, g->from, g->to);
    if (saved < kMinSaving) continue;
    auto& points = variation.guide.points;
    const auto span = donor.guide.points.begin();
    const auto rest = points.erase(points.begin() + g->begin, points.begin() + g->end);
    points.insert(rest, span + g->from, span + g->to);
    variation.start = g->begin;
    variation.guide.tail = std::min(g->begin + (g->to - g->from), variation.guide.last());
    variation.guide.tailShift = int32_t(g->end) - int32_t(g->begin + (g->to - g->from));
    return true;
  }
  return false;
}

}  // namespace obby::solve
