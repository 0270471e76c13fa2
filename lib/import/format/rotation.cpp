// A rotation id is 6 * n(x axis) + n(y axis) + 1, where n numbers the directions +X +Y +Z -X -Y -Z
// from 0.
#include "import/format/rotation.h"

namespace obby::importer {
namespace {

Vec3 direction(int number) {
  const float sign = number < 3 ? 1.0f : -1.0f;
  const int axis = number % 3;
  return {axis == 0 ? sign : 0.0f, axis == 1 ? sign : 0.0f, axis == 2 ? sign : 0.0f};
}

// Turns the -0 of a cross product into +0: files that spell out the same rotation have plain zeros.
Vec3 withoutNegativeZero(Vec3 v) { return v + Vec3{0, 0, 0}; }

}  // namespace

std::optional<Mat3> rotationFromId(uint8_t id) {
  if (id < 1 || id > 36) return std::nullopt;
  const int x = (id - 1) / 6, y = (id - 1) % 6;
  if (x % 3 == y % 3) return std::nullopt;  // the x and y axes are parallel
  const Vec3 xAxis = direction(x), yAxis = direction(y);
  return Mat3{xAxis, yAxis, withoutNegativeZero(cross(xAxis, yAxis))};
}

Mat3 rotationFromRows(const std::array<float, 9>& r) {
  return {{r[0], r[3], r[6]}, {r[1], r[4], r[7]}, {r[2], r[5], r[8]}};
}

}  // namespace obby::importer
