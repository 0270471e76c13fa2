#include "view/picture/view_choice.h"

#include <algorithm>
#include <cmath>

#include "geom/shapes/table.h"
#include "level/record_values.h"
#include "view/extent.h"

namespace obby::view {

namespace {

// The numbers of web/src/scene/view_choice.js and subject.js.
constexpr int kAzimuths = 12;
constexpr float kFirstYaw = 0.55f;                 // radians
constexpr float kPitches[] = {0.55f, 0.8f, 1.1f};  // radians downward
constexpr float kSteep = 0.08f;                    // cost of each steeper pitch
constexpr float kFills = 0.3f;                     // worth of a view that fills the picture
constexpr float kLevelView = 0.28f;                // ... whose points are all equally far away
constexpr float kReads = 0.06f;                    // ... with the start on the left
constexpr float kTolerance = 0.6f;                 // studs a part may be before a point
constexpr float kMaxHalf = 24;                     // studs; larger goals are framed in part
constexpr float kWaist = 2, kHead = 5.5f;          // studs above the feet
constexpr float kAroundStart = 4;                  // studs
constexpr float kNearStart = 12;                   // studs of the floor around the start
constexpr size_t kSeen = 48;                       // tested points of a trajectory
constexpr size_t kFramed = 200;                    // framed points of a trajectory
constexpr size_t kMaxSolutions = 12;               // framed solutions
constexpr int kEnds = 6;                           // weight of start and goal
constexpr float kBefore = 1e4f;                    // studs from an orthographic camera
constexpr int kShort = 90;                         // height of a trial picture, pixels

struct View {
  Vec3 look;
  size_t steepness;
};

std::vector<View> views() {
  std::vector<View> out;
  for (size_t p = 0; p < std::size(kPitches); ++p) {
    for (int i = 0; i < kAzimuths; ++i) {
      const float yaw = kFirstYaw + 6.2831853f * float(i) / kAzimuths;
      const float across = std::cos(kPitches[p]);
      out.push_back(
          {{-std::sin(yaw) * across, -std::sin(kPitches[p]), -std::cos(yaw) * across}, p});
    }
  }
  return out;
}

void addBox(const Box& box, std::vector<Vec3>& out) {
  for (int i = 0; i < 8; ++i)
    out.push_back(
        {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z});
}

void addRegion(schema::Region::Reader region, std::vector<Vec3>& out) {
  const Box box = boxOf(cornersOf(region));
  const Vec3 middle = (box.lo + box.hi) * 0.5f;
  const Vec3 half = min((box.hi - box.lo) * 0.5f, Vec3{kMaxHalf, kMaxHalf, kMaxHalf});
  addBox({middle - half, middle + half}, out);
}

void addRegions(const QueryEntry& query, Subject& out) {
  if (!query.query) return;
  forRegions(query.reader(), [&](schema::Region::Reader region, RegionKind kind) {
    if (kind == RegionKind::avoid) return;
    addRegion(region, out.frame);
    const Box box = boxOf(cornersOf(region));
    if (kind == RegionKind::goal) out.to = (box.lo + box.hi) * 0.5f;
  });
}

void addPath(const std::vector<Vec3>& feet, std::vector<Vec3>& out) {
  const size_t step = std::max<size_t>(1, feet.size() / kFramed);
  for (size_t i = 0; i < feet.size(); i += step) {
    out.push_back(feet[i]);
    out.push_back(feet[i] + Vec3{0, kHead, 0});
  }
}

// Adds the top of the part that the player stands on, as far as it is near.
void addFloor(const LevelEntry& level, Vec3 feet, std::vector<Vec3>& out) {
  const Vec3 near{kNearStart, kNearStart, kNearStart};
  Box floor{feet - near, feet - near};
  bool found = false;
  for (const auto part : level.reader().getParts()) {
    const Box box = boxOf(cornersOf(part));
    if (box.hi.y > feet.y + 1 || box.hi.y <= floor.hi.y) continue;
    if (box.lo.x > feet.x || box.hi.x < feet.x || box.lo.z > feet.z || box.hi.z < feet.z) continue;
    floor = box;
    found = true;
  }
  if (!found) return;
  const Vec3 lo = max(floor.lo, feet - near), hi = min(floor.hi, feet + near);
  addBox({{lo.x, hi.y, lo.z}, hi}, out);
}

// Returns the trajectories to frame: the solutions, or else the closest.
std::vector<const PathEntry*> framedPaths(const QueryEntry& query) {
  std::vector<const PathEntry*> out;
  for (const PathKind kind : {PathKind::solution, PathKind::closest}) {
    for (const PathEntry& path : query.paths) {
      if (path.kind == kind && out.size() < kMaxSolutions) out.push_back(&path);
    }
    if (!out.empty()) break;
  }
  return out;
}

// Adds the two parts of the step that is impossible.
void addCut(const LevelEntry& level, const QueryEntry& query, std::vector<Vec3>& out) {
  if (!query.result || !query.answer().hasCut()) return;
  const auto cut = query.answer().getCut();
  const auto parts = level.reader().getParts();
  for (const int32_t part : {cut.getFrom(), cut.getTo()}) {
    if (part >= 0 && uint32_t(part) < parts.size())
      out.push_back(level::vec(parts[uint32_t(part)].getPosition()));
  }
}

// Returns true if the point is inside the solid: rays towards it from two sides end at a surface.
bool isInside(const Solid& solid, Vec3 point) {
  constexpr float kFar = 1e4f;  // studs
  const Vec3 local = toLocal(solid.pose, point);
  return geom::visitShape(solid.kind, [&](auto shape) {
    const auto meets = [&](float side) {
      geom::RayHit hit{};
      return decltype(shape)::castRay(solid.shape, local + Vec3{0, side * kFar, 0},
                                      Vec3{0, -side, 0}, kFar, hit);
    };
    return meets(1) && meets(-1);
  });
}

// Returns the share of the points that are not hidden.
float visible(const std::vector<Vec3>& points, const Camera& camera, int width, int height,
              const std::vector<Solid>& solids) {
  if (points.empty()) return 1;
  Depths seen(camera, width, height);
  for (const Solid& solid : solids) {
    if (solid.coverage <= 0.5f) continue;
    if (camera.perspective && isInside(solid, camera.eye)) return 0;
    seen.add(solid, 0);
  }
  float count = 0;
  for (const Vec3 point : points) {
    const Vec3 p = camera.project(point);
    if (!(p.z > 0 && p.x >= 0 && p.y >= 0 && p.x < float(width) && p.y < float(height))) continue;
    count += p.z <= seen.depth(int(p.x), int(p.y)) + kTolerance ? 1.0f : 0.0f;
  }
  return count / float(points.size());
}

// Returns the worth of a view's composition: how well it fills the picture, how level it is, and
// whether it reads from left to right.
float composition(const Subject& subject, const Camera& camera, int width, int height) {
  Vec3 lo{1e30f, 1e30f, 1e30f}, hi{-1e30f, -1e30f, -1e30f};
  for (const Vec3 point : subject.frame) {
    const Vec3 p = camera.project(point);
    lo = min(lo, p);
    hi = max(hi, p);
  }
  const float fills = (hi.x - lo.x) / float(width) * (hi.y - lo.y) / float(height);
  const bool reads =
      subject.from && subject.to && dot(*subject.to - *subject.from, camera.right) > 0;
  return kFills * std::sqrt(fills) + kLevelView * lo.z / hi.z + (reads ? kReads : 0);
}

}  // namespace

Subject subjectOf(const LevelEntry& level, const QueryEntry* query) {
  Subject out;
  if (query) {
    addRegions(*query, out);
    if (query->compiled) {
      const Vec3 feet = query->compiled->start().feet;
      const Vec3 around{kAroundStart, 0, kAroundStart};
      addBox({feet - around, feet + around + Vec3{0, kHead, 0}}, out.frame);
      addFloor(level, feet, out.frame);
      out.from = feet + Vec3{0, kWaist, 0};
    }
    for (const PathEntry* path : framedPaths(*query)) addPath(path->playback.feet, out.frame);
    addCut(level, *query, out.frame);
  }
  if (out.frame.empty()) addBox(courseOf(level), out.frame);
  for (int i = 0; i < kEnds; ++i) {
    for (const auto& end : {out.from, out.to}) {
      if (end) out.seen.push_back(*end);
    }
  }
  const std::vector<const PathEntry*> framed =
      query ? framedPaths(*query) : std::vector<const PathEntry*>();
  if (!framed.empty()) {
    const std::vector<Vec3>& feet = framed[0]->playback.feet;
    const size_t step = std::max<size_t>(1, feet.size() / kSeen);
    for (size_t i = 0; i < feet.size(); i += step) out.seen.push_back(feet[i] + Vec3{0, kWaist, 0});
  }
  return out;
}

Vec3 bestLook(const Subject& subject, const std::vector<Solid>& solids, int width, int height,
              bool perspective) {
  const int wide = std::clamp(kShort * width / std::max(height, 1), kShort / 4, kShort * 4);
  Vec3 best{0, -1, 0};
  float most = -1e30f;
  for (const View& view : views()) {
    Camera camera = framed(subject.frame, view.look, wide, kShort, perspective);
    if (!perspective) camera.eye -= camera.forward * kBefore;
    const float worth = visible(subject.seen, camera, wide, kShort, solids) +
                        composition(subject, camera, wide, kShort) - kSteep * float(view.steepness);
    if (worth <= most) continue;
    most = worth;
    best = view.look;
  }
  return best;
}

}  // namespace obby::view
