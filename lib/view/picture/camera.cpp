#include "view/picture/camera.h"

#include <algorithm>
#include <cmath>

namespace obby::view {

namespace {

// Pixels per stud at distance 1, divided by the picture's height in pixels.
constexpr float kField = 0.9f;
constexpr float kMargin = 0.9f;  // share of the picture that the points may fill
constexpr float kNearest = 8;    // min studs from the eye to the nearest point
constexpr float kMin = 8;        // min studs across a picture

struct Extent {
  float lo = 1e30f, hi = -1e30f;
  void take(float v) {
    lo = std::min(lo, v);
    hi = std::max(hi, v);
  }
  float middle() const { return (lo + hi) / 2; }
  float size() const { return hi - lo; }
};

struct Spread {
  Extent x, y, z;
};

Spread spreadOf(const Camera& camera, const std::vector<Vec3>& points) {
  Spread out;
  for (const Vec3 point : points) {
    const Vec3 p = camera.project(point);
    out.x.take(p.x);
    out.y.take(p.y);
    out.z.take(p.z);
  }
  return out;
}

// Moves the camera until all points fit, centered in the picture.
void stepBack(Camera& camera, const std::vector<Vec3>& points, int width, int height) {
  const float space = kMargin * float(width), spaceY = kMargin * float(height);
  for (int round = 0; round < 40; ++round) {
    const Spread s = spreadOf(camera, points);
    const float distance = (s.z.lo + s.z.hi) / 2;
    camera.eye += camera.right * ((s.x.middle() - camera.middleX) / camera.scale * distance) -
                  camera.up * ((s.y.middle() - camera.middleY) / camera.scale * distance);
    const float fills = std::max(s.x.size() / space, s.y.size() / spaceY);
    const float step = s.z.lo < kNearest ? kNearest - s.z.lo : (fills - 1) * distance * 0.7f;
    const float max = s.z.lo - kNearest;  // max step forward
    camera.eye -= camera.forward * std::max(step, -std::max(max, 0.0f));
  }
}

}  // namespace

Vec3 Camera::project(Vec3 point) const {
  const Vec3 d = point - eye;
  const float z = dot(d, forward);
  const float by = perspective ? scale / (z > 1e-3f ? z : 1e-3f) : scale;
  return {middleX + dot(d, right) * by, middleY - dot(d, up) * by, z};
}

void Camera::ray(float x, float y, Vec3& origin, Vec3& direction) const {
  const Vec3 side = right * ((x - middleX) / scale) + up * ((middleY - y) / scale);
  origin = perspective ? eye : eye + side;
  direction = perspective ? forward + side : forward;
}

Camera framed(const std::vector<Vec3>& points, Vec3 forward, int width, int height,
              bool perspective) {
  Camera camera;
  camera.forward = normalize(forward);
  const bool down = absf(camera.forward.y) > 0.999f;
  camera.right = normalize(cross(camera.forward, down ? Vec3{0, 0, -1} : Vec3{0, 1, 0}));
  camera.up = cross(camera.right, camera.forward);
  camera.middleX = float(width) / 2;
  camera.middleY = float(height) / 2;
  camera.perspective = perspective;
  Box box{points[0], points[0]};
  for (const Vec3 p : points) box = join(box, {p, p});
  const Vec3 middle = (box.lo + box.hi) * 0.5f;
  const float far = length(box.hi - box.lo) + kNearest;
  camera.eye = middle - camera.forward * far;
  if (perspective) {
    camera.scale = kField * 2 * float(height);
    stepBack(camera, points, width, height);
    return camera;
  }
  const Spread s = spreadOf(camera, points);  // in studs, since the scale is 1
  camera.eye +=
      camera.right * (s.x.middle() - camera.middleX) - camera.up * (s.y.middle() - camera.middleY);
  camera.scale = kMargin * std::min(float(width) / std::max(s.x.size(), kMin),
                                    float(height) / std::max(s.y.size(), kMin));
  return camera;
}

}  // namespace obby::view
