#include "view/picture/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text.h"
#include "view/extent.h"
#include "view/picture/drawn_parts.h"
#include "view/picture/view_choice.h"
#include "view/picture/world.h"
#include "view/raster.h"
#include "view/thinning.h"

namespace obby::view {

namespace {

constexpr float kLegend = 30;            // pixels below the drawing
constexpr float kMinHeight = 80;         // pixels
constexpr float kBeyond = 2;             // studs around the subject of a drawing
constexpr float kThinnedPixels = 0.15f;  // tolerance of simplified trajectories

constexpr const char* kStyle =
    "<style>.page{fill:#fff}text{font:13px system-ui,sans-serif;fill:#222}.part{stroke:#0006;"
    "stroke-width:.8}.away{stroke-dasharray:3 3}path{fill:none;stroke-linejoin:round}"
    ".solution{stroke:#d98a00;stroke-width:3}"
    ".attempt{stroke:#8a6250;stroke-width:1;opacity:.6}.death{stroke:#c81e24;stroke-width:2}"
    ".goal{stroke:#2868d8}.avoid{stroke:#b02896}.waypoint{stroke:#a87000}.region{fill:none;"
    "stroke-width:2;stroke-dasharray:5 4}.start{fill:#188c5c}.jump{fill:#fff;stroke:#222}"
    "@media(prefers-color-scheme:dark){.page{fill:#181a1f}text{fill:#ddd}.part{stroke:#fff6}"
    ".solution{stroke:#ffb81c}.attempt{stroke:#c49a86}}</style>\n";

struct Sheet {
  Paper paper;
  float width, height;  // pixels
};

// Fits the drawing to the points. It is no higher than wide. `points` must not be empty.
Sheet sheetOf(Vec3 across, Vec3 down, const std::vector<Vec3>& points, int width) {
  float x0 = 1e30f, x1 = -1e30f, y0 = 1e30f, y1 = -1e30f;
  for (const Vec3 p : points) {
    x0 = std::min(x0, dot(p, across)), x1 = std::max(x1, dot(p, across));
    y0 = std::min(y0, dot(p, down)), y1 = std::max(y1, dot(p, down));
  }
  const float space = float(width) - 2 * kPaperMargin;  // pixels
  const float scale = space / std::max({x1 - x0, y1 - y0, 1.0f});
  const float left = (x0 + x1 - space / scale) / 2;
  return {{across, down, scale, {left, y0}},
          float(width),
          std::max((y1 - y0) * scale + 2 * kPaperMargin, kMinHeight) + kLegend};
}

// The direction is that of a picture (view_choice.h). The size of a trial is as wide as the page.
Sheet bestSheet(const LevelEntry& level, const QueryEntry* query, const World& world, int width) {
  const Subject subject = subjectOf(level, query);
  const int height = width * 9 / 16;
  const Vec3 look = bestLook(subject, world.solids, width, height, false);
  const Camera camera = framed(subject.frame, look, width, height, false);
  std::vector<Vec3> points;
  for (const Vec3 p : subject.frame) {
    for (const float side : {-kBeyond, kBeyond}) {
      points.push_back(p + camera.right * side);
      points.push_back(p + camera.up * side);
    }
  }
  return sheetOf(camera.right, -camera.up, points, width);
}

Sheet sheetFor(const LevelEntry& level, const QueryEntry* query, const World& world,
               const DrawingOptions& options) {
  if (options.side == Side::best) return bestSheet(level, query, world, options.width);
  const Box extent = query ? extentOf(level, *query) : level.level->bounds();
  const Vec3 along = alongOf(extent, query);
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? extent.hi.x : extent.lo.x, i & 2 ? extent.hi.y : extent.lo.y,
                       i & 4 ? extent.hi.z : extent.lo.z});
  // The drawing is never mirrored: from above, the right-hand side along the level is down.
  const Vec3 down = options.side == Side::above ? cross(along, Vec3{0, 1, 0}) : Vec3{0, -1, 0};
  return sheetOf(along, down, corners, options.width);
}

float distanceTo(Vec2 a, Vec2 b, Vec2 p) {
  const float dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const float t =
      squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0f, 1.0f) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

std::vector<Vec2> lineOf(const Playback& play, const Paper& paper) {
  std::vector<Vec2> all, out;
  for (const Vec3 feet : play.feet) all.push_back(paper.of(feet));
  const auto distance = [&](size_t a, size_t b, size_t p) {
    return distanceTo(all[a], all[b], all[p]);
  };
  for (const size_t i : thinned(all.size(), kThinnedPixels, distance)) out.push_back(all[i]);
  return out;
}

std::string circle(Vec2 at, double radius, const char* kind) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", kind,
                     double(at.x), double(at.y), radius);
}

std::string cross(Vec2 at) {
  return fmt::format("<path class=\"death\" d=\"M{0:.1f} {1:.1f}l8 8m0 -8l-8 8\"/>\n",
                     double(at.x) - 4, double(at.y) - 4);
}

std::string feetOf(const PathEntry& path, const Paper& paper) {
  const bool solves = path.kind == PathKind::solution;
  std::string out = fmt::format("<path class=\"{}\" d=\"{}\"/>\n", solves ? "solution" : "attempt",
                                pathData(lineOf(path.playback, paper), false));
  if (!solves && path.playback.outcome != schema::Outcome::RUNNING)
    out += cross(paper.of(path.playback.feet.back()));
  if (!solves) return out;
  for (const uint32_t tick : path.playback.jumpTicks)
    out +=
        circle(paper.of(path.playback.feet[std::min<size_t>(tick, path.playback.feet.size() - 1)]),
               3, "jump");
  return out;
}

std::string regionsOf(schema::Query::Reader query, const Paper& paper) {
  std::string out;
  int number = 0;
  forRegions(query, [&](schema::Region::Reader region, RegionKind kind) {
    std::vector<Vec2> points;
    for (const Vec3 c : cornersOf(region)) points.push_back(paper.of(c));
    const char* name = kind == RegionKind::avoid  ? "avoid"
                       : kind == RegionKind::goal ? "goal"
                                                  : "waypoint";
    const std::vector<Vec2> hull = convexHull(std::move(points));
    out += fmt::format("<path class=\"region {}\" d=\"{}\"/>\n", name, pathData(hull, true));
    if (kind != RegionKind::waypoint || hull.empty()) return;
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", double(hull[0].x) + 4,
                       double(hull[0].y) + 14, ++number);
  });
  return out;
}

std::string queryOf(const QueryEntry& query, const Paper& paper, bool attempts) {
  std::string out = query.query ? regionsOf(query.reader(), paper) : std::string();
  for (const bool solutions : {false, true}) {
    for (const PathEntry& path : query.paths) {
      if (path.kind == PathKind::attempt && !attempts) continue;
      if ((path.kind == PathKind::solution) == solutions) out += feetOf(path, paper);
    }
  }
  if (query.compiled) out += circle(paper.of(query.compiled->start().feet), 6, "start");
  return out;
}

// Joins the names of level and query that are not empty.
std::string titleOf(const LevelEntry& level, const QueryEntry* query) {
  const std::string name = level.level->name(), id = query ? query->id : "";
  return name + (name.empty() || id.empty() ? "" : ": ") + id;
}

std::string captionOf(const std::string& title, Side side, float studs) {
  constexpr const char* kSides[] = {"", "from above, ", "from the side, "};
  return title + (title.empty() ? "" : ", ") + kSides[size_t(side)] + lengthText(studs) +
         " studs across";
}

}  // namespace

std::string drawingOf(const LevelEntry& level, const QueryEntry* query,
                      const DrawingOptions& options) {
  const uint32_t tick = query && query->compiled ? query->compiled->start().tick : 0;
  const World world = worldOf(level, tick);
  const Sheet sheet = sheetFor(level, query, world, options);
  const std::string title = titleOf(level, query);
  const float across = (sheet.width - 2 * kPaperMargin) / sheet.paper.scale;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n",
             double(sheet.width), double(sheet.height), io::escapeMarkup(title)) +
         kStyle + "<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n" +
         // The picture is nested, so that lines outside of it do not cross the text.
         fmt::format("<svg width=\"{:.0f}\" height=\"{:.0f}\">\n", double(sheet.width),
                     double(sheet.height - kLegend)) +
         drawnParts(world, sheet.paper, sheet.width, sheet.height - kLegend) +
         (query ? queryOf(*query, sheet.paper, options.attempts) : "") +
         fmt::format("</svg>\n<text x=\"{:.0f}\" y=\"{:.1f}\">{}</text>\n</svg>\n",
                     double(kPaperMargin), double(sheet.height) - 10,
                     io::escapeMarkup(captionOf(title, options.side, across)));
}

}  // namespace obby::view
