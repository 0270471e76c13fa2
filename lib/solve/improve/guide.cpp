#include "solve/improve/guide.h"

#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

namespace {

// Returns true if keys act otherwise than by walking and jumping.
bool needsExactKeys(const sim::World& w) {
  return w.state == sim::State::climbing || w.state == sim::State::seated ||
         w.state == sim::State::fallingDown;
}

}  // namespace

Guide guideAlong(const Line& line) { return guideAlong(line, 0, line.ticks()); }

Guide guideAlong(const Line& line, uint32_t from, uint32_t to) {
  Guide guide;
  guide.points.reserve(to - from + 1);
  for (uint32_t t = from; t <= to; ++t) {
    const sim::World& w = line.worlds[t];
    GuidePoint point{w.position, 0, {}};
    if (line.ticks() > 0) point.action = line.actions[std::min(t, line.ticks() - 1)];
    if (grounded(w)) point.marks |= kGuideGround;
    if (needsExactKeys(w)) point.marks |= kGuideRepeat;
    if (t < line.ticks() && line.worlds[t + 1].jumps > w.jumps) point.marks |= kGuideJump;
    guide.points.push_back(point);
  }
  return guide;
}

void index(Guide& guide) {
  const auto count = uint32_t(guide.points.size());
  guide.nextGround.resize(count);
  guide.nextJump.resize(count);
  uint32_t ground = count, jump = count;
  for (uint32_t i = count; i-- > 0;) {
    if (guide.points[i].marks & kGuideGround) ground = i;
    if (guide.points[i].marks & kGuideJump) jump = i;
    guide.nextGround[i] = ground;
    guide.nextJump[i] = jump;
  }
}

}  // namespace obby::solve
