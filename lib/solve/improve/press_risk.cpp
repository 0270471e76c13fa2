#include "solve/improve/press_risk.h"

#include <algorithm>

#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

namespace {

constexpr int kOffsets[] = {-4, -2, 2, 4};  // ticks
constexpr uint32_t kBefore = 6;             // ticks before the jump at which a press begins
constexpr uint32_t kAfter = 12;             // ticks of the line after the landing
constexpr uint32_t kPatience = 30;          // ticks that a landing may come late
constexpr float kMaxBelow = 2;              // studs that a landing may be lower

}  // namespace

struct PressRisk::Press {
  Guide guide;
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  uint32_t landing;  // point of the guide
  uint32_t ticksLeft;
  Follower follower;

  bool isLower() const { return world.position.y < guide.points[landing].position.y - kMaxBelow; }
  bool landed() const {
    if (world.outcome == sim::Outcome::goal) return true;
    return follower.at() >= landing && grounded(world) && !isLower();
  }
  bool isOver() const {
    return ticksLeft == 0 || world.outcome != sim::Outcome::running || landed();
  }
};

void PressRisk::addPresses(const Line& line, uint32_t jump, std::vector<Press>& presses) const {
  const uint32_t from = jump - std::min(jump, kBefore);
  uint32_t landing = jump + 1;
  while (landing < line.ticks() && !grounded(line.worlds[landing])) ++landing;
  const uint32_t to = std::min(landing + kAfter, line.ticks());
  const auto bodies = line.bodiesAt(from);
  const sim::Action last = from > 0 ? line.actions[from - 1] : sim::Action{};
  for (const int offset : kOffsets) {
    const int64_t pressed = int64_t(jump) + offset;
    if (pressed < from || pressed >= landing) continue;
    Press& p = presses.emplace_back(Press{guideAlong(line, from, to),
                                          line.worlds[from],
                                          {bodies.begin(), bodies.end()},
                                          landing - from,
                                          landing - from + kPatience,
                                          {}});
    p.guide.points[jump - from].marks &= uint8_t(~kGuideJump);
    p.guide.points[size_t(pressed - from)].marks |= kGuideJump;
    index(p.guide);
    p.follower = Follower(0, {6, 512, problem_.hasClock}, p.world, last);
  }
}

uint32_t PressRisk::missed(const Line& line) {
  std::vector<Press> presses;
  for (uint32_t t = 0; t < line.ticks(); ++t) {
    if (line.worlds[t + 1].jumps > line.worlds[t].jumps) addPresses(line, t, presses);
  }
  std::vector<Press*> running;
  for (Press& p : presses) running.push_back(&p);
  while (!running.empty()) {
    for (Press* p : running) {
      const sim::Action keys = p->follower.next(p->guide, p->world, problem_.level.params);
      lockstep_.add(p->world, p->bodies, keys);
      --p->ticksLeft;
    }
    lockstep_.advance();
    std::erase_if(running, [](const Press* p) { return p->isOver(); });
  }
  return uint32_t(std::ranges::count_if(presses, [](const Press& p) { return !p.landed(); }));
}

}  // namespace obby::solve
