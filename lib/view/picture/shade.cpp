#include "view/picture/shade.h"

#include <cmath>

namespace obby::view {

namespace {

constexpr Color kSkyAbove{0.80f, 0.87f, 0.95f}, kSkyBelow{0.95f, 0.96f, 0.97f};
constexpr Color kWhite{1, 1, 1}, kBlack{0, 0, 0};
constexpr float kShade = 0.56f;    // relative light in the shade
constexpr float kSunBias = 0.15f;  // studs by which a surface may be behind the sun's depth and
                                   // still be lit
constexpr float kPatternStep = 2;  // studs
constexpr float kPattern = 0.22f;  // share of black in every other field
constexpr float kLine = 0.45f;     // share of black at edges
constexpr float kStep = 0.04f;     // relative depth difference that counts as an edge
constexpr int kSoft = 1;           // samples of the sun's buffer to each side

bool otherField(Pattern pattern, Vec3 p) {
  const auto cell = [](float v) { return int(std::floor(v / kPatternStep)); };
  switch (pattern) {
    case Pattern::plain: return false;
    case Pattern::stripes: return cell(p.x + p.y + p.z) & 1;
    case Pattern::checks: return (cell(p.x + 0.01f) + cell(p.y + 0.01f) + cell(p.z + 0.01f)) & 1;
  }
  return false;
}

// Returns the share of the sun's samples around the point that see it.
float lit(const Depths& sun, Vec3 point) {
  const Vec3 p = sun.camera().project(point);
  const int x = int(p.x), y = int(p.y);
  int seen = 0, asked = 0;
  for (int dy = -kSoft; dy <= kSoft; ++dy) {
    for (int dx = -kSoft; dx <= kSoft; ++dx) {
      if (x + dx < 0 || y + dy < 0 || x + dx >= sun.width() || y + dy >= sun.height()) continue;
      ++asked;
      seen += p.z <= sun.depth(x + dx, y + dy) + kSunBias + 0.004f * float(asked);
    }
  }
  return asked == 0 ? 1 : float(seen) / float(asked);
}

// Returns true if depth or normal changes abruptly to the neighbour on the right or below.
bool edgeAt(const Depths& seen, int x, int y) {
  const uint32_t id = seen.id(x, y);
  const float depth = seen.depth(x, y);
  for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
    if (x + dx >= seen.window().x1 || y + dy >= seen.window().y1) continue;
    const uint32_t other = seen.id(x + dx, y + dy);
    if (id == kNothing && other == kNothing) continue;
    if (id == kNothing || other == kNothing) return true;
    const float gap = std::fabs(depth - seen.depth(x + dx, y + dy));
    const bool turned = dot(seen.normal(x, y), seen.normal(x + dx, y + dy)) < 0.7f;
    if (gap > kStep * depth || turned) return true;
  }
  return false;
}

Color surfaceAt(const Depths& seen, const Depths& sun, const std::vector<Surface>& surfaces, int x,
                int y) {
  const Surface& s = surfaces[seen.id(x, y)];
  const Vec3 point = seen.point(x, y), normal = seen.normal(x, y);
  Color color = s.color;
  if (otherField(s.pattern, point)) color = mix(color, kBlack, kPattern);
  const float facing = std::max(dot(normal, sunward()), 0.0f);
  const float direct = facing > 0 ? facing * lit(sun, point + normal * 0.05f) : 0;
  const float ambient = kShade * (0.86f + 0.14f * normal.y);
  const float light = ambient + (1.06f - kShade) * direct;
  return light <= 1 ? mix(kBlack, color, light) : mix(color, kWhite, light - 1);
}

}  // namespace

Vec3 sunward() { return normalize(Vec3{0.42f, 1, 0.3f}); }

std::vector<Color> shade(const Depths& seen, const Depths& sun,
                         const std::vector<Surface>& surfaces) {
  const Samples& w = seen.window();
  std::vector<Color> out;
  out.reserve(size_t(w.x1 - w.x0) * size_t(w.y1 - w.y0));
  for (int y = w.y0; y < w.y1; ++y) {
    for (int x = w.x0; x < w.x1; ++x) {
      Color color = seen.id(x, y) == kNothing
                        ? mix(kSkyAbove, kSkyBelow, float(y) / float(seen.height()))
                        : surfaceAt(seen, sun, surfaces, x, y);
      if (edgeAt(seen, x, y)) color = mix(color, kBlack, kLine);
      out.push_back(color);
    }
  }
  return out;
}

}  // namespace obby::view
