#include "view/picture/canvas.h"

#include <algorithm>
#include <cmath>

#include "geom/shapes/table.h"

namespace obby::view {

namespace {

constexpr float kFar = 1e30f;
constexpr float kNear = 0.1f;  // studs

// Thresholds of a 4 x 4 ordered dither.
constexpr uint8_t kDither[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

}  // namespace

Color colorOf(Rgb c) { return {float(c.r) / 255, float(c.g) / 255, float(c.b) / 255}; }

Rgb rgbOf(Color c) {
  const auto byte = [](float v) { return uint8_t(std::lround(std::clamp(v, 0.0f, 1.0f) * 255)); };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

Color mix(Color a, Color b, float share) {
  const auto one = [share](float x, float y) { return x + (y - x) * share; };
  return {one(a.r, b.r), one(a.g, b.g), one(a.b, b.b)};
}

Depths::Depths(const Camera& camera, int width, int height, const Samples& window)
    : camera_(camera),
      width_(width),
      height_(height),
      window_(window),
      depths_(size_t(window.x1 - window.x0) * size_t(window.y1 - window.y0), kFar),
      ids_(depths_.size(), kNothing),
      normals_(depths_.size()) {}

Samples Depths::samplesOf(const Solid& solid) const {
  float x0 = kFar, y0 = kFar, x1 = -kFar, y1 = -kFar;
  int near = 0;  // corners too near or behind the eye, which have no projection
  for (int i = 0; i < 8; ++i) {
    const Vec3 h = solid.shape.half;
    const Vec3 corner{i & 1 ? h.x : -h.x, i & 2 ? h.y : -h.y, i & 4 ? h.z : -h.z};
    const Vec3 p = camera_.project(toWorld(solid.pose, corner));
    near += camera_.perspective && p.z < kNear;
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  }
  if (near == 8) return {};
  if (near > 0) return window_;
  const Samples& w = window_;
  const auto clamped = [](float v, int min, int max) {
    return int(std::clamp(v, float(min), float(max)));
  };
  return {clamped(x0 - 1, w.x0, w.x1), clamped(y0 - 1, w.y0, w.y1), clamped(x1 + 2, w.x0, w.x1),
          clamped(y1 + 2, w.y0, w.y1)};
}

// Ray casts use the simulator's shape code, so the picture shows what players collide with.
void Depths::add(const Solid& solid, uint32_t id) {
  const Samples b = samplesOf(solid);
  geom::visitShape(solid.kind, [&](auto shape) {
    for (int y = b.y0; y < b.y1; ++y) {
      for (int x = b.x0; x < b.x1; ++x) {
        const uint8_t threshold = kDither[(y % 4) * 4 + x % 4];
        if (solid.coverage < 1 && float(threshold) >= solid.coverage * 16) continue;
        Vec3 origin, direction;
        camera_.ray(float(x) + 0.5f, float(y) + 0.5f, origin, direction);
        const Vec3 local = toLocal(solid.pose.rotation, direction);
        geom::RayHit hit{};
        const size_t i = at(x, y);
        if (!decltype(shape)::castRay(solid.shape, toLocal(solid.pose, origin), local, depths_[i],
                                      hit) ||
            hit.t < kNear)
          continue;
        depths_[i] = hit.t;
        ids_[i] = id;
        normals_[i] = solid.pose.rotation * hit.normal;
      }
    }
    return 0;
  });
}

Vec3 Depths::point(int x, int y) const {
  Vec3 origin, direction;
  camera_.ray(float(x) + 0.5f, float(y) + 0.5f, origin, direction);
  return origin + direction * depth(x, y);
}

}  // namespace obby::view
