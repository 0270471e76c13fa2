// A query as the simulator and the search read it: regions, parts to touch, limits. Plain data, for
// device code.
#pragma once

#include "geom/region.h"
#include "level/level_view.h"

namespace obby::level {

// Studs below a level top at which feet still count as standing on it. A landing dips less.
constexpr float kStandDepth = 0.5f;
// Parts that hold a player elsewhere than on their top, or whose top can move.
constexpr uint32_t kHeldElsewhere = kTruss | kSeat | kMoving | kTriggered | kDynamic;

// A target of a query: a region, or a part that the player must touch.
struct TargetView {
  geom::Region region;                      // the region, or the space around a part to touch
  uint32_t firstTouch = 0, touchCount = 0;  // colliders in QueryView::touched; 0 for a region
  bool stand = false;                       // the feet must come to rest in the region
};

// Limits of a segment, which leads from the start or a waypoint to the next waypoint or the goal.
struct SegmentLimits {
  int32_t jumps = -1;  // -1 for any number
  uint32_t ticks = 0;  // 0 for no limit
};

struct WaypointView {
  TargetView target;
  int32_t maxJumps = -1;  // max jumps from the start until arrival; -1 for any number
  uint32_t ticks = 0;     // max ticks from the start until arrival; 0 for no limit
  SegmentLimits segment{};
};

constexpr uint32_t kMaxVisits = 32;  // World::visited has a bit for each

struct QueryView {
  TargetView goal;
  const TargetView* otherGoals = nullptr;
  const WaypointView* waypoints = nullptr;  // the player must reach them in this order
  const TargetView* visits = nullptr;       // the player must reach them in any order
  const TargetView* avoid = nullptr;
  const uint32_t* touched = nullptr;  // colliders of the parts to touch or to avoid
  uint32_t otherGoalCount = 0, waypointCount = 0, visitCount = 0, avoidCount = 0, touchedCount = 0;
  int32_t minJumps = 0;
  int32_t maxJumps = -1;        // -1 for any number
  uint32_t timeLimitTicks = 0;  // 0 for no limit
  uint32_t startTick = 0;       // level clock at the start of the trajectory
  SegmentLimits last{};         // limits of the segment that ends at the goal
  float maxDamage = -1;         // health; -1 for any amount
  uint32_t forbidden = 0;       // bits of the sim::State values that end the trajectory
  uint16_t tricks = 0;          // tricks that the player may use; bits as in Params::tricks
  uint16_t directionStep = 0;   // Params::directionStep
};

template <class Table>
OBBY_DEVICE void forTables(QueryView& q, Table&& table) {
  table(q.otherGoals, q.otherGoalCount);
  table(q.waypoints, q.waypointCount);
  table(q.visits, q.visitCount);
  table(q.avoid, q.avoidCount);
  table(q.touched, q.touchedCount);
}

}  // namespace obby::level
