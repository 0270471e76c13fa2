#include "engine/values/rotations.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace obby::engine {
namespace {

constexpr float kParallel = 1e-6f;
constexpr double kPiDouble = 3.14159265358979323846;

struct Turn {
  double sin, cos;
};
Turn turnOf(double angle) { return {std::sin(angle), std::cos(angle)}; }

// Builds a matrix from its rows.
Mat3 rows(double xx, double xy, double xz, double yx, double yy, double yz, double zx, double zy,
          double zz) {
  return {{float(xx), float(yx), float(zx)},
          {float(xy), float(yy), float(zy)},
          {float(xz), float(yz), float(zz)}};
}

double arcSin(double x) { return std::asin(std::clamp(x, -1.0, 1.0)); }

}  // namespace

Mat3 fromAnglesXyz(Angles angles) {
  const Turn x = turnOf(angles.x), y = turnOf(angles.y), z = turnOf(angles.z);
  return rows(y.cos * z.cos, -y.cos * z.sin, y.sin,  //
              x.cos * z.sin + x.sin * y.sin * z.cos, x.cos * z.cos - x.sin * y.sin * z.sin,
              -x.sin * y.cos,  //
              x.sin * z.sin - x.cos * y.sin * z.cos, x.sin * z.cos + x.cos * y.sin * z.sin,
              x.cos * y.cos);
}

Mat3 fromAnglesYxz(Angles angles) {
  const Turn x = turnOf(angles.x), y = turnOf(angles.y), z = turnOf(angles.z);
  return rows(y.cos * z.cos + y.sin * x.sin * z.sin, y.sin * x.sin * z.cos - y.cos * z.sin,
              y.sin * x.cos,                         //
              x.cos * z.sin, x.cos * z.cos, -x.sin,  //
              y.cos * x.sin * z.sin - y.sin * z.cos, y.sin * z.sin + y.cos * x.sin * z.cos,
              y.cos * x.cos);
}

Angles anglesXyz(const Mat3& r) {
  return {std::atan2(-double(r.z.y), double(r.z.z)), arcSin(double(r.z.x)),
          std::atan2(-double(r.y.x), double(r.x.x))};
}

Angles anglesYxz(const Mat3& r) {
  return {arcSin(-double(r.z.y)), std::atan2(double(r.z.x), double(r.z.z)),
          std::atan2(double(r.x.y), double(r.y.y))};
}

AxisAngle axisAngle(const Mat3& r) {
  const Vec3 twice = {r.y.z - r.z.y, r.z.x - r.x.z, r.x.y - r.y.x};
  const double sine = 0.5 * double(length(twice));
  const double cosine = 0.5 * (double(r.x.x) + double(r.y.y) + double(r.z.z) - 1);
  const double angle = std::atan2(sine, cosine);
  if (sine > 1e-6) return {normalize(twice), angle};
  if (cosine > 0) return {{1, 0, 0}, 0};
  // For half a turn, the axis is the largest column of (R + 1) / 2.
  const Vec3 columns[] = {r.x + Vec3{1, 0, 0}, r.y + Vec3{0, 1, 0}, r.z + Vec3{0, 0, 1}};
  const Vec3 best = *std::max_element(std::begin(columns), std::end(columns),
                                      [](Vec3 a, Vec3 b) { return dot(a, a) < dot(b, b); });
  return {normalize(best), kPiDouble};
}

Mat3 looking(Vec3 direction, Vec3 up) {
  const Vec3 back = normalize(-direction, Vec3{0, 0, 1});
  Vec3 right = cross(normalize(up), back);
  if (dot(right, right) < kParallel) right = cross(Vec3{0, 0, back.y > 0 ? -1.0f : 1.0f}, back);
  if (dot(right, right) < kParallel) right = Vec3{1, 0, 0};
  right = normalize(right);
  return {right, cross(back, right), back};
}

Mat3 orthonormal(const Mat3& r) {
  const Vec3 x = normalize(r.x, Vec3{1, 0, 0});
  const Vec3 y = normalize(r.y - x * dot(x, r.y), Vec3{0, 1, 0});
  return {x, y, cross(x, y)};
}

Mat3 between(const Mat3& from, const Mat3& to, float share) {
  if (from.x == to.x && from.y == to.y && from.z == to.z) return from;
  const AxisAngle turn = axisAngle(inverse(from) * to);
  return from * rotationAbout(turn.axis, turn.angle * double(share));
}

}  // namespace obby::engine
