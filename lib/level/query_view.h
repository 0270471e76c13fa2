// A query as the simulator and the search read it: regions, parts to touch, limits. Plain data, for
// device code.
#pragma once

#include "geom/region.h"
#include "level/level_view.h"

namespace obby::level {

// Studs below a level top at which feet still stand on it: as far as a landing dips, and more.
constexpr float kStandDepth = 0.5f;
// Parts that hold a player elsewhere than on their top, or whose top is elsewhere later.
constexpr uint32_t kHeldElsewhere = kTruss | kSeat | kMoving | kTriggered | kLoose;

// What a query names: a region, or a part that has to be touched.
struct TargetView {
  geom::Region region;                      // of a part to touch: the room around it
  uint32_t firstTouch = 0, touchCount = 0;  // its colliders in QueryView::touched; 0: the region
  bool stand = false;                       // the feet have to come to rest in the region
};

// Limits of a segment: what lies between a waypoint, or the start, and the next or the goal.
struct SegmentLimits {
  int32_t jumps = -1;  // -1: any
  uint32_t ticks = 0;  // 0: none
};

struct WaypointView {
  TargetView target;
  int32_t maxJumps = -1;  // since the start, on arrival; -1: any
  uint32_t ticks = 0;     // since the start, on arrival; 0: none
  SegmentLimits segment{};
};

constexpr uint32_t kMaxVisits = 32;  // World::visited has a bit for each

struct QueryView {
  TargetView goal;
  const TargetView* otherGoals = nullptr;
  const WaypointView* waypoints = nullptr;  // in this order
  const TargetView* visits = nullptr;       // in any order
  const TargetView* avoid = nullptr;
  const uint32_t* touched = nullptr;  // colliders of the parts to touch or not to touch
  uint32_t otherGoalCount = 0, waypointCount = 0, visitCount = 0, avoidCount = 0, touchedCount = 0;
  int32_t minJumps = 0;
  int32_t maxJumps = -1;        // -1: any
  uint32_t timeLimitTicks = 0;  // 0: none
  uint32_t startTick = 0;       // level clock at the start of the playthrough
  SegmentLimits last{};         // of the segment that ends at the goal
  float maxDamage = -1;         // health; -1: any
  uint32_t forbidden = 0;       // sim::State values, a bit each
  uint16_t tricks = 0;          // that the player may use: Params::tricks
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
