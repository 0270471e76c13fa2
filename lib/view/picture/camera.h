// Where a picture is taken from, and what of the world a pixel sees.
#pragma once

#include <vector>

#include "math/vec.h"

namespace obby::view {

// Perspective, or parallel rays where `perspective` is false. Pixels: x to the right, y down.
struct Camera {
  Vec3 eye;                        // of parallel rays: any point on the picture's middle ray
  Vec3 right, up, forward;         // unit
  float scale = 1;                 // pixels a stud, at a distance of one stud where perspective
  float middleX = 0, middleY = 0;  // pixel that looks forward
  bool perspective = true;

  // x, y in pixels, z the distance along `forward`, studs; behind the eye it is not positive.
  Vec3 project(Vec3 point) const;
  // A point and a direction whose part along `forward` is 1: point + t * direction is at distance
  // t.
  void ray(float x, float y, Vec3& origin, Vec3& direction) const;
};

// Looks along `forward` so that all points are in a picture of that size, with a margin, and no
// smaller than needed. At least one point.
Camera framed(const std::vector<Vec3>& points, Vec3 forward, int width, int height,
              bool perspective);

}  // namespace obby::view
