// A sketch of a trajectory for a player to follow: where to be, where to jump, and what to repeat
// key by key.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/improve/line.h"

namespace obby::solve {

enum GuideMark : uint8_t {
  kGuideGround = 1,    // the player is on something
  kGuideJump = 2,      // a jump begins here
  kGuideRepeat = 4,    // repeat the keys instead of steering
  kGuideEdgeJump = 8,  // jump where the floor ends
};

struct GuidePoint {
  Vec3 position;  // of the feet, studs
  uint8_t marks = 0;
  sim::Action action;  // the keys to repeat
};

struct Guide {
  std::vector<GuidePoint> points;  // one per tick, at least one
  // Index of the next point from each on that is on ground, and of the next with a jump; the number
  // of points if there is none.
  std::vector<uint32_t> nextGround, nextJump;
  // From point `tail` on, point i is tick i + tailShift of the line that the guide was made from.
  uint32_t tail = 0;
  int32_t tailShift = 0;

  uint32_t last() const { return uint32_t(points.size()) - 1; }
};

// A line with the guide that follows it.
struct GuidedLine {
  Line line;
  Guide guide;
};

// Return the guide that follows the line, or its ticks `from` to `to`. index() must be called
// before it is used.
Guide guideAlong(const Line& line);
Guide guideAlong(const Line& line, uint32_t from, uint32_t to);

// Fills in nextGround and nextJump.
void index(Guide& guide);

}  // namespace obby::solve
