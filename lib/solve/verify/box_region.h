// Regions in double precision, read from their records. The verifier's code shares nothing with
// geom/region.h, so that an error there is not repeated here.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "schema/obby.capnp.h"

namespace obby::solve {

struct Point {
  double x = 0, y = 0, z = 0;
};

inline Point point(schema::Vec3::Reader v) { return {v.getX(), v.getY(), v.getZ()}; }

// An oriented box, read from its record.
class BoxRegion {
 public:
  explicit BoxRegion(schema::Region::Reader region)
      : center_(point(region.getPosition())), size_(point(region.getSize())) {
    const auto q = region.getRotation();
    const double n = std::sqrt(double(q.getX()) * q.getX() + double(q.getY()) * q.getY() +
                               double(q.getZ()) * q.getZ() + double(q.getW()) * q.getW());
    const double x = q.getX() / n, y = q.getY() / n, z = q.getZ() / n, w = q.getW() / n;
    axes_[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    axes_[1] = {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
    axes_[2] = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
  }

  // Returns true if the vertical segment of `height` studs above the feet meets the box.
  bool holds(Point feet, double height) const {
    const double half[3] = {size_.x / 2, size_.y / 2, size_.z / 2};
    double from = 0, to = height;
    for (int i = 0; i < 3; ++i) {
      const Point& a = axes_[i];
      const double o = along(a, minus(feet, center_));
      if (std::abs(a.y) < 1e-9) {
        if (std::abs(o) > half[i]) return false;
        continue;
      }
      const double t0 = (-half[i] - o) / a.y, t1 = (half[i] - o) / a.y;
      from = std::max(from, std::min(t0, t1));
      to = std::min(to, std::max(t0, t1));
    }
    return from <= to;
  }

  // Returns true if holds() is true anywhere on the straight line between two positions of the
  // feet. s is a share of the line, t a share of the height. Six half planes clip the square of all
  // (s, t) to the part inside the box.
  bool holdsAlong(Point from, Point to, double height) const {
    const double half[3] = {size_.x / 2, size_.y / 2, size_.z / 2};
    std::vector<Share> left = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 3; ++i) {
      const Point& a = axes_[i];
      const double o = along(a, minus(from, center_));
      const double s = along(a, minus(to, from)), t = a.y * height;
      left = cut(cut(left, half[i] - o, s, t), half[i] + o, -s, -t);
    }
    return !left.empty();
  }

  // Returns the feet of a player who starts in this region.
  Point floor() const {
    const double up[3] = {std::abs(axes_[0].y), std::abs(axes_[1].y), std::abs(axes_[2].y)};
    const double drop =
        up[1] > 0.999 ? size_.y / 2 : (up[0] * size_.x + up[1] * size_.y + up[2] * size_.z) / 2;
    return {center_.x, center_.y - drop, center_.z};
  }

 private:
  struct Share {
    double s, t;
  };

  static Point minus(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  static double along(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

  // Returns the part of a convex polygon with s * ofS + t * ofT <= max.
  static std::vector<Share> cut(const std::vector<Share>& polygon, double max, double ofS,
                                double ofT) {
    std::vector<Share> out;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Share a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const double slackA = max - a.s * ofS - a.t * ofT, slackB = max - b.s * ofS - b.t * ofT;
      if (slackA >= 0) out.push_back(a);
      if ((slackA >= 0) == (slackB >= 0)) continue;
      const double part = slackA / (slackA - slackB);
      out.push_back({a.s + (b.s - a.s) * part, a.t + (b.t - a.t) * part});
    }
    return out;
  }

  Point center_, size_;
  Point axes_[3];  // axes of the box, in the world
};

}  // namespace obby::solve
