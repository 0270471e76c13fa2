#include "view/picture/pen.h"

#include <algorithm>
#include <cmath>

namespace obby::view {

namespace {

constexpr float kNearPlane = 0.2f;  // studs; points nearer to the eye are not drawn
constexpr float kBias = 0.35f;      // studs by which a line may lie behind the surface below it

// Edges of a box as pairs of corners, whose bits are the sides of X, Y and Z.
constexpr int kEdges[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                               {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

}  // namespace

Pen::Pen(const Depths& seen, std::vector<Color>& colors)
    : seen_(seen), colors_(colors), strokes_(colors.size(), 0) {}

void Pen::put(int x, int y, float depth, const Stroke& stroke) {
  const Samples& window = seen_.window();
  if (x < window.x0 || y < window.y0 || x >= window.x1 || y >= window.y1) return;
  const size_t i = seen_.at(x, y);
  if (strokes_[i] == stroke_) return;
  strokes_[i] = stroke_;
  const bool hidden = depth > seen_.depth(x, y) + kBias;
  colors_[i] = mix(colors_[i], stroke.color, stroke.opacity * (hidden ? stroke.behind : 1));
}

void Pen::segment(Vec3 a, Vec3 b, const Stroke& stroke) {
  if (a.z < kNearPlane || b.z < kNearPlane) return;
  const float r = stroke.width / 2, w = float(seen_.width()), h = float(seen_.height());
  if (std::max(a.x, b.x) < -r || std::max(a.y, b.y) < -r || std::min(a.x, b.x) > w + r ||
      std::min(a.y, b.y) > h + r)
    return;
  const float dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const auto clamped = [](float v, float max) { return int(std::clamp(v, 0.0f, max)); };
  const int y0 = std::max(clamped(std::min(a.y, b.y) - r, h), seen_.window().y0);
  const int y1 = std::min(clamped(std::max(a.y, b.y) + r + 1, h), seen_.window().y1);
  for (int y = y0; y < y1; ++y) {
    // Restricts the row to the part near the line.
    float from = std::min(a.x, b.x), to = std::max(a.x, b.x);
    if (std::fabs(dy) > 1e-3f) {
      const float t0 = std::clamp((float(y) - r - a.y) / dy, 0.0f, 1.0f);
      const float t1 = std::clamp((float(y) + 1 + r - a.y) / dy, 0.0f, 1.0f);
      from = a.x + dx * std::min(t0, t1), to = a.x + dx * std::max(t0, t1);
      if (from > to) std::swap(from, to);
    }
    for (int x = clamped(from - r, w); x < clamped(to + r + 1, w); ++x) {
      const float px = float(x) + 0.5f - a.x, py = float(y) + 0.5f - a.y;
      const float t = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0f, 1.0f) : 0;
      const float ex = px - t * dx, ey = py - t * dy;
      if (ex * ex + ey * ey <= r * r) put(x, y, a.z + (b.z - a.z) * t, stroke);
    }
  }
}

void Pen::line(const std::vector<Vec3>& points, const Stroke& stroke) {
  begin();
  for (size_t i = 0; i + 1 < points.size(); ++i)
    segment(seen_.camera().project(points[i]), seen_.camera().project(points[i + 1]), stroke);
}

void Pen::cross(Vec3 at, float size, const Stroke& stroke) {
  begin();
  const Vec3 p = seen_.camera().project(at);
  segment({p.x - size, p.y - size, p.z}, {p.x + size, p.y + size, p.z}, stroke);
  segment({p.x - size, p.y + size, p.z}, {p.x + size, p.y - size, p.z}, stroke);
}

void Pen::disc(Vec3 at, float size, const Stroke& stroke) {
  begin();
  const Vec3 p = seen_.camera().project(at);
  Stroke wide = stroke;
  wide.width = 2 * size;
  segment(p, p, wide);
}

// Scans only the box's own window, a small part of most pictures.
void Pen::fill(const Solid& box, const Stroke& stroke) {
  const Samples window = seen_.samplesOf(box);
  if (window.empty()) return;
  Depths alone(seen_.camera(), seen_.width(), seen_.height(), window);
  alone.add(box, 0);
  begin();
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      if (alone.id(x, y) != kNothing) put(x, y, alone.depth(x, y), stroke);
    }
  }
}

void Pen::box(const Solid& box, const Stroke& stroke, float veil) {
  Stroke thin = stroke;
  thin.opacity = veil;
  fill(box, thin);
  begin();
  Vec3 corners[8];
  const Vec3 h = box.shape.half;
  for (int i = 0; i < 8; ++i)
    corners[i] = seen_.camera().project(
        toWorld(box.pose, {i & 1 ? h.x : -h.x, i & 2 ? h.y : -h.y, i & 4 ? h.z : -h.z}));
  for (const auto& edge : kEdges) segment(corners[edge[0]], corners[edge[1]], stroke);
}

}  // namespace obby::view
