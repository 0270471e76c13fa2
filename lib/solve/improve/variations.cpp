#include "solve/improve/variations.h"

#include <algorithm>

#include "solve/improve/splice.h"
#include "solve/search/rollouts/action_runs.h"

namespace obby::solve {

namespace {

constexpr uint32_t kMinSpan = 12, kDoublings = 5;  // spans of 12 to 383 ticks
constexpr float kMaxBend = 2.5f;                   // studs
constexpr uint32_t kMaxJumpShift = 14;             // ticks
constexpr uint32_t kRunUp = 30;                    // ticks before a removed jump
constexpr float kSpliceShare = 0.4f;               // of the variations, if there are donors

struct Span {
  uint32_t from, to;  // ticks of the line, from < to
};

Span drawSpan(const Line& line, Random& random) {
  const uint32_t n = line.ticks();
  const uint32_t shortest = kMinSpan << random.below(kDoublings);
  const uint32_t length = shortest + random.below(shortest);
  const uint32_t from = random.below(n);
  return {from, std::min(from + length, n)};
}

FollowSettings drawSettings(const VariationContext& context, Random& random) {
  constexpr int kSlacks[] = {256, 512, 1024, 2048};
  return {3 + uint32_t(random.unit() * random.unit() * 60), kSlacks[random.below(4)],
          context.hasClock && random.below(4) != 0};
}

// Follows the rest of the line, and cuts its corners.
void follow(const Line& line, Variation& variation, Random& random) {
  variation.start = random.below(line.ticks());
  variation.guide.tail = variation.start;
}

// Returns the points of a straight run from `from` to `to`, both excluded. Stands still for `wait`
// points before it, and for those that are left after it.
std::vector<GuidePoint> straight(const GuidePoint& from, const GuidePoint& to, uint32_t count,
                                 uint32_t wait, float walked, uint8_t marks) {
  std::vector<GuidePoint> points;
  for (uint32_t i = 1; i <= count; ++i) {
    const float share = std::clamp(float(int32_t(i) - int32_t(wait)) * walked, 0.0f, 1.0f);
    points.push_back({from.position + share * (to.position - from.position), marks, from.action});
  }
  return points;
}

// Replaces a span by a straight run. May jump where the floor ends, or at a random place.
void cut(const Line& line, const VariationContext& context, Variation& variation, Random& random) {
  Guide& guide = variation.guide;
  Span span = drawSpan(line, random);
  while (span.to < line.ticks() && !(guide.points[span.to].marks & kGuideGround)) ++span.to;
  const GuidePoint from = guide.points[span.from], to = guide.points[span.to];
  const Vec3 run = to.position - from.position;
  const float ticks = std::max(1.0f, sqrtf32(run.x * run.x + run.z * run.z) / context.studsPerTick);
  const bool synced = variation.settings.synced;
  const uint32_t count =
      synced ? span.to - span.from - 1 : std::min(uint32_t(ticks), span.to - span.from - 1);
  const uint32_t kind = random.below(3);
  const uint32_t idle = count - std::min(count, uint32_t(ticks));
  const uint32_t wait = random.below(2) ? idle : 0;
  auto points = straight(from, to, count, wait, 1 / ticks, kind == 1 ? kGuideEdgeJump : 0);
  if (kind == 2 && !points.empty()) points[random.below(count)].marks |= kGuideJump;
  guide.points[span.from].marks &= uint8_t(~kGuideJump);
  const auto first = guide.points.begin() + span.from + 1;
  const auto rest = guide.points.erase(first, guide.points.begin() + span.to);
  guide.points.insert(rest, points.begin(), points.end());
  variation.start = span.from;
  guide.tail = span.from + 1 + count;
  guide.tailShift = int32_t(span.to) - int32_t(guide.tail);
}

std::vector<uint32_t> launchesOf(const Guide& guide) {
  std::vector<uint32_t> jumps;
  for (uint32_t i = 0; i < guide.points.size(); ++i) {
    if (guide.points[i].marks & kGuideJump) jumps.push_back(i);
  }
  return jumps;
}

// Removes one jump, or several in a row.
void removeJumps(const Line& line, Variation& variation, Random& random) {
  const std::vector<uint32_t> jumps = launchesOf(variation.guide);
  if (jumps.empty()) return follow(line, variation, random);
  const auto first = random.below(uint32_t(jumps.size()));
  const uint32_t more = random.below(3) == 0 ? random.below(uint32_t(jumps.size())) : 0;
  const size_t end = std::min(jumps.size(), size_t(first) + 1 + more);
  for (size_t i = first; i < end; ++i)
    variation.guide.points[jumps[i]].marks &= uint8_t(~kGuideJump);
  const uint32_t early = std::min(jumps[first], random.below(kRunUp));
  variation.start = jumps[first] - early;
  variation.guide.tail = std::min(variation.guide.last(), jumps[end - 1] + 40);
}

void shiftJump(const Line& line, Variation& variation, Random& random) {
  const std::vector<uint32_t> jumps = launchesOf(variation.guide);
  if (jumps.empty()) return follow(line, variation, random);
  const uint32_t from = jumps[random.below(uint32_t(jumps.size()))];
  const int32_t by = int32_t(1 + random.below(kMaxJumpShift)) * (random.below(2) ? 1 : -1);
  const auto to = uint32_t(std::clamp(int32_t(from) + by, 0, int32_t(variation.guide.last())));
  variation.guide.points[from].marks &= uint8_t(~kGuideJump);
  variation.guide.points[to].marks |= kGuideJump;
  variation.mayCostMore = true;
  variation.start = std::min(from, to);
  variation.start -= std::min(variation.start, random.below(kRunUp));
  variation.guide.tail = std::min(variation.guide.last(), std::max(from, to) + 40);
}

// Moves a span sideways, most in its middle.
void bend(const Line& line, Variation& variation, Random& random) {
  const Span span = drawSpan(line, random);
  const Vec3 by{kMaxBend * (2 * random.unit() - 1), 0, kMaxBend * (2 * random.unit() - 1)};
  const float length = float(span.to - span.from);
  for (uint32_t i = span.from; i < span.to; ++i) {
    const float x = float(i - span.from) / length;
    variation.guide.points[i].position += 4 * x * (1 - x) * by;
  }
  variation.start = span.from;
  variation.guide.tail = span.to;
}

// Stands still for a span, for example on a part that moves.
void rest(const Line& line, Variation& variation, Random& random) {
  const Span span = drawSpan(line, random);
  for (uint32_t i = span.from; i < span.to; ++i) {
    GuidePoint& point = variation.guide.points[i];
    point.marks = uint8_t((point.marks | kGuideRepeat) & ~kGuideJump);
    point.action = {};
  }
  variation.start = span.from;
  variation.guide.tail = span.to;
}

struct Run {
  uint32_t from, to;  // ticks with the same keys
};

std::vector<Run> runsAfter(const Line& line, uint32_t from) {
  std::vector<Run> runs;
  for (uint32_t t = from; t < line.ticks(); ++t) {
    const bool more = t > from && sameKeys(line.actions[t], line.actions[t - 1]);
    if (more)
      ++runs.back().to;
    else
      runs.push_back({t, t + 1});
    if (runs.size() > 12) break;
  }
  return runs;
}

// Gives a span the mean of two directions, or that of one of them.
sim::Action merged(const sim::Action& a, const sim::Action& b, uint32_t kind) {
  if (kind != 2 || !a.walk || !b.walk) return kind == 1 ? b : a;
  sim::Action mean = a;
  mean.heading = Turns(a.heading + int16_t(Turns(b.heading - a.heading)) / 2);
  return mean;
}

// Changes the keys themselves: fewer of them, or for a shorter time. The rest is repeated key by
// key, or followed.
void simplify(const Line& line, Variation& variation, Random& random) {
  Guide& guide = variation.guide;
  const std::vector<Run> runs = runsAfter(line, random.below(line.ticks()));
  const size_t pick = random.below(uint32_t(runs.size()));
  const Run run = runs[pick];
  const Run next = pick + 1 < runs.size() ? runs[pick + 1] : run;
  const uint32_t kind = random.below(4);
  uint32_t removed = 0;
  if (kind == 3) {
    removed = 1 + random.below(run.to - run.from);
  } else {
    const sim::Action action = merged(line.actions[run.from], line.actions[next.from], kind);
    for (uint32_t t = run.from; t < next.to; ++t) {
      const bool jump = guide.points[t].action.jump;
      guide.points[t].action = action;
      if (random.below(2)) guide.points[t].action.jump = jump;
    }
  }
  guide.points.erase(guide.points.begin() + run.from, guide.points.begin() + run.from + removed);
  variation.start = run.from;
  guide.tail = std::min(guide.last(), next.to - removed);
  guide.tailShift = int32_t(removed);
  const bool repeatAll = random.below(2) == 0;
  const uint32_t end = repeatAll ? guide.last() + 1 : std::min(guide.tail + 5, guide.last());
  for (uint32_t i = run.from; i < end; ++i) guide.points[i].marks |= kGuideRepeat;
}

}  // namespace

std::vector<Variation> sweep(const GuidedLine& base, const VariationContext& context) {
  std::vector<Variation> variations;
  for (const bool jumps : {true, false}) {
    for (const uint32_t lookahead : {6u, 12u, 20u, 35u}) {
      Variation variation{base.guide, 0, {lookahead, 512, context.hasClock}};
      if (!jumps) {
        for (GuidePoint& point : variation.guide.points) point.marks &= uint8_t(~kGuideJump);
        variation.guide.tail = variation.guide.last();
      }
      index(variation.guide);
      variations.push_back(std::move(variation));
    }
  }
  return variations;
}

Variation drawVariation(const GuidedLine& base, const VariationContext& context, Random& random) {
  const Line& line = base.line;
  Variation variation{base.guide, 0, drawSettings(context, random)};
  const bool splices = !context.donors.empty() && random.unit() < kSpliceShare;
  if (!splices || !splice(line, context.donors, variation, random)) {
    switch (random.below(context.hasClock ? 9 : 8)) {
      case 0: follow(line, variation, random); break;
      case 1:
      case 2: cut(line, context, variation, random); break;
      case 3: removeJumps(line, variation, random); break;
      case 4: shiftJump(line, variation, random); break;
      case 5: bend(line, variation, random); break;
      case 8: rest(line, variation, random); break;
      default: simplify(line, variation, random); break;
    }
  }
  index(variation.guide);
  return variation;
}

}  // namespace obby::solve
