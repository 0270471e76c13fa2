// Draws a query from above, with the longer side across. Parts are drawn in order of height, so
// that the highest is visible.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "table/columns.h"
#include "table/flow.h"
#include "view/extent.h"
#include "view/picture/world.h"
#include "view/raster.h"
#include "view/roles.h"
#include "view/text_report.h"

namespace obby::view {
namespace {

constexpr size_t kMaxColumns = 110, kMaxName = 60;

constexpr Ink kPart{':', "░", {84, 92, 106}}, kKill{'x', "▒", {214, 60, 64}},
    kMoving{'~', "~", {164, 139, 250}}, kStart{'S', "S", {53, 196, 141}},
    kGoal{'G', "G", {63, 140, 255}}, kAvoid{'-', "╌", {150, 80, 140}},
    kWaypoint{'o', "o", {200, 160, 70}}, kSolution{'*', "●", {255, 225, 140}},
    kAttempt{'.', "·", {150, 110, 80}}, kEnd{'+', "✕", {255, 120, 110}},
    kSpecial{'=', "▤", {76, 195, 221}}, kAway{',', "┈", {46, 51, 62}};

Ink inkOf(Role role) {
  switch (role) {
    case Role::kill: return kKill;
    case Role::goal: return kGoal;
    case Role::moving: return kMoving;
    case Role::vanish:
    case Role::conveyor:
    case Role::pad: return kSpecial;
    default: return kPart;
  }
}

// Maps the world seen from above, with the longer side across, never mirrored.
struct Frame {
  bool along;  // the longer side is Z: -Z points right

  Vec2 of(Vec3 v) const { return along ? Vec2{-v.z, v.x} : Vec2{v.x, v.z}; }
};

std::vector<Vec2> footprint(const Corners& corners, Frame frame) {
  std::vector<Vec2> points;
  for (const Vec3 c : corners) points.push_back(frame.of(c));
  return convexHull(std::move(points));
}

const Ink& inkOf(RegionKind kind) {
  switch (kind) {
    case RegionKind::avoid: return kAvoid;
    case RegionKind::visit:
    case RegionKind::waypoint: return kWaypoint;
    case RegionKind::goal: break;
  }
  return kGoal;
}

Corners cornersAround(const Solid& solid) {
  const Vec3 h = solid.shape.half;
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 local{i & 1 ? h.x : -h.x, i & 2 ? h.y : -h.y, i & 4 ? h.z : -h.z};
    corners[size_t(i)] = toWorld(solid.pose, local);
  }
  return corners;
}

struct Drawn {
  Role role;
  bool there;  // false for a part that is away
  float top;
  std::vector<Vec2> hull;
};

// Returns the parts within the extent in drawing order: those away at that tick of the level clock,
// then the others, lowest first. Moving parts have their poses at that tick.
std::vector<Drawn> partsOf(const LevelEntry& level, uint32_t tick, Frame frame, const Box& extent) {
  const World world = worldOf(level, tick);
  const std::vector<Role> roles = rolesOf(level.reader());
  std::vector<Drawn> drawn;
  const auto draw = [&](Role role, bool away, const Corners& corners) {
    const Box box = boxOf(corners);
    const bool meets = box.lo.x <= extent.hi.x && extent.lo.x <= box.hi.x &&
                       box.lo.z <= extent.hi.z && extent.lo.z <= box.hi.z;
    if (meets && role != Role::ghost) {
      drawn.push_back({role, !away, box.hi.y, footprint(corners, frame)});
    }
  };
  std::vector<bool> simulated(roles.size(), false);
  for (size_t i = 0; i < world.solids.size(); ++i) {
    const uint32_t part = level.level->view().colliders[i].part;
    simulated[part] = true;
    draw(roles[part], world.away[i], cornersAround(world.solids[i]));
  }
  // Parts without a collider, such as a goal to walk into, are not in the simulator.
  for (uint32_t i = 0; i < roles.size(); ++i) {
    if (!simulated[i]) draw(roles[i], false, cornersOf(level.reader().getParts()[i]));
  }
  std::stable_sort(drawn.begin(), drawn.end(), [](const Drawn& a, const Drawn& b) {
    return a.there == b.there ? a.top < b.top : b.there;
  });
  return drawn;
}

void drawPath(Raster& raster, const Playback& play, Frame frame, const Ink& ink) {
  for (size_t i = 0; i + 1 < play.feet.size(); ++i) {
    raster.line(frame.of(play.feet[i]), frame.of(play.feet[i + 1]), ink);
  }
}

void outline(Raster& raster, schema::Region::Reader region, Frame frame, const Ink& ink) {
  const std::vector<Vec2> hull = footprint(cornersOf(region), frame);
  for (size_t i = 0; i < hull.size(); ++i) raster.line(hull[i], hull[(i + 1) % hull.size()], ink);
}

// Attempts lie under the parts, since many of them would hide the level.
void drawAttempts(Raster& raster, const QueryEntry& query, Frame frame) {
  for (const PathEntry& path : query.paths) {
    if (path.kind == PathKind::solution) continue;
    drawPath(raster, path.playback, frame, kAttempt);
    raster.dot(frame.of(path.playback.feet.back()), kEnd);
  }
}

void drawQuery(Raster& raster, const QueryEntry& query, Frame frame) {
  if (query.query) {
    forRegions(query.reader(), [&](schema::Region::Reader region, RegionKind kind) {
      outline(raster, region, frame, inkOf(kind));
    });
  }
  for (const PathEntry& path : query.paths) {
    if (path.kind == PathKind::solution) drawPath(raster, path.playback, frame, kSolution);
  }
  if (query.compiled) raster.dot(frame.of(query.compiled->start().feet), kStart);
}

// Marks that only some queries have.
struct Drawings {
  bool away = false, waypoint = false, avoid = false, solution = false, attempt = false;
};

Drawings drawingsOf(const QueryEntry& query, const std::vector<Drawn>& parts) {
  Drawings has;
  has.away = !parts.empty() && !parts.front().there;
  if (query.query) {
    forRegions(query.reader(), [&](schema::Region::Reader, RegionKind kind) {
      has.avoid = has.avoid || kind == RegionKind::avoid;
      has.waypoint = has.waypoint || kind == RegionKind::waypoint || kind == RegionKind::visit;
    });
  }
  if (query.paths.empty()) return has;
  has.solution = query.paths.front().kind == PathKind::solution;  // solutions come first
  has.attempt = query.paths.back().kind != PathKind::solution;
  return has;
}

std::string legend(const table::TerminalTraits& terminal, const Drawings& has) {
  table::Flow lines(terminal.width, 2);
  const auto add = [&](const Ink& ink, const char* text) {
    const bool halves = terminal.color && terminal.utf8;
    const std::string glyph = halves          ? "■"
                              : terminal.utf8 ? std::string(ink.wide)
                                              : std::string(1, ink.glyph);
    lines.add(table::colored(glyph, ink.color, terminal) + " " + text,
              2 + table::columnCount(text));
  };
  add(kStart, "start");
  add(kGoal, "goal");
  add(kPart, "part");
  add(kKill, "kills");
  add(kMoving, "moves");
  add(kSpecial, "jump pad, conveyor or vanishing part");
  if (has.away) add(kAway, "absent at the start");
  if (has.waypoint) add(kWaypoint, "waypoint");
  if (has.avoid) add(kAvoid, "to avoid");
  if (has.solution) add(kSolution, "solution");
  if (has.attempt) {
    add(kAttempt, "attempt");
    add(kEnd, "end of an attempt");
  }
  return lines.text();
}

// `studs`: width of a column.
std::string heading(const table::TerminalTraits& terminal, const QueryEntry& query, float studs,
                    Frame frame) {
  const size_t space = std::min(kMaxName, terminal.width - 1);
  table::Flow lines(terminal.width, 1);
  const auto add = [&](const std::string& text) { lines.add(text, table::columnCount(text)); };
  if (!query.id.empty()) add(table::fitted(query.id, space, !terminal.utf8) + ",");
  add("from above,");
  add(lengthText(studs) + " studs per column,");
  add(frame.along ? "-Z to the right" : "+X to the right");
  return lines.text();
}

}  // namespace

std::string queryMap(const Report& report, const QueryEntry& query,
                     const table::TerminalTraits& terminal, size_t maxRows) {
  if (query.level < 0) return {};
  const LevelEntry& level = report.levels[size_t(query.level)];
  const Box extent = extentOf(level, query);
  const Frame frame{extent.hi.z - extent.lo.z > extent.hi.x - extent.lo.x};
  const Vec2 a = frame.of(extent.lo), b = frame.of(extent.hi);
  Raster raster({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                std::min(terminal.width, kMaxColumns), maxRows, terminal);
  drawAttempts(raster, query, frame);
  const uint32_t tick = query.compiled ? query.compiled->start().tick : 0;
  const std::vector<Drawn> parts = partsOf(level, tick, frame, extent);
  for (const Drawn& part : parts) raster.fill(part.hull, part.there ? inkOf(part.role) : kAway);
  drawQuery(raster, query, frame);
  return heading(terminal, query, raster.pixelWidth(), frame) + raster.text() +
         legend(terminal, drawingsOf(query, parts));
}

}  // namespace obby::view
