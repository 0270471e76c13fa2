#include "view/picture/drawn_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/shapes/table.h"
#include "view/picture/depth_order.h"
#include "view/picture/facets.h"
#include "view/raster.h"

namespace obby::view {

namespace {

constexpr int kOutline = 48;      // directions in which support points of an outline are queried
constexpr float kUnlit = 0.62f;   // brightness of a face that the sun does not meet
constexpr float kEdgeOn = 0.01f;  // cosine below which a face is not seen

std::vector<Vec2> outlineOf(const Solid& solid, const Paper& paper) {
  std::vector<Vec2> points;
  geom::visitShape(solid.kind, [&](auto shape) {
    for (int i = 0; i < kOutline; ++i) {
      const float angle = float(i) * 6.2831853f / kOutline;
      const Vec3 toward = paper.across * std::cos(angle) + paper.down * std::sin(angle);
      const Vec3 local = toLocal(solid.pose.rotation, toward);
      points.push_back(paper.of(toWorld(solid.pose, shape.corner(solid.shape, local))));
    }
    return 0;
  });
  return convexHull(std::move(points));
}

std::string hex(Color c) {
  const Rgb rgb = rgbOf(c);
  return fmt::format("#{:02x}{:02x}{:02x}", rgb.r, rgb.g, rgb.b);
}

bool meetsPage(const std::vector<Vec2>& hull, float width, float height) {
  Vec2 lo = hull[0], hi = hull[0];
  for (const Vec2 p : hull) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  return hi.x > 0 && lo.x < width && hi.y > 0 && lo.y < height;
}

// A top face keeps its colour.
Color shaded(Color c, Vec3 normal) {
  const float sun = std::clamp(dot(normal, sunward()) / sunward().y, 0.0f, 1.0f);
  const float bright = kUnlit + (1 - kUnlit) * sun;
  return {c.r * bright, c.g * bright, c.b * bright};
}

std::string polygon(const std::vector<Vec2>& points, Color color, bool away, float coverage) {
  return fmt::format("<path class=\"part{}\" d=\"{}\" style=\"fill:{};fill-opacity:{:.2f}\"/>\n",
                     away ? " away" : "", pathData(points, true), hex(color), double(coverage));
}

}  // namespace

std::string pathData(const std::vector<Vec2>& points, bool closed) {
  std::string out;
  for (const Vec2 p : points)
    out += fmt::format("{}{:.1f} {:.1f}", out.empty() ? "M" : "L", double(p.x), double(p.y));
  return out + (closed ? "Z" : "");
}

std::string drawnParts(const World& world, const Paper& paper, float width, float height) {
  std::vector<std::vector<Vec2>> outlines;
  for (const Solid& solid : world.solids) {
    std::vector<Vec2>& outline = outlines.emplace_back(outlineOf(solid, paper));
    if (outline.size() < 3 || !meetsPage(outline, width, height)) outline.clear();
  }
  const Vec3 toward = paper.toward();
  std::string out;
  for (const size_t i : depthOrder(world.solids, outlines, paper)) {
    const Solid& solid = world.solids[i];
    const Color color = world.surfaces[i].color;
    const std::vector<Facet> facets = facetsOf(solid);
    if (facets.empty()) out += polygon(outlines[i], color, world.away[i], solid.coverage);
    for (const Facet& facet : facets) {
      if (dot(facet.normal, toward) > -kEdgeOn) continue;
      std::vector<Vec2> points;
      for (const Vec3 corner : facet.corners) points.push_back(paper.of(corner));
      const std::vector<Vec2> face = convexHull(std::move(points));
      if (face.size() < 3) continue;
      out += polygon(face, shaded(color, facet.normal), world.away[i], solid.coverage);
    }
  }
  return out;
}

}  // namespace obby::view
