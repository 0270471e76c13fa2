// The camera of a picture.
#pragma once

#include <vector>

#include "math/vec.h"

namespace obby::view {

// Perspective or, if `perspective` is false, orthographic. Pixels: x to the right, y down.
struct Camera {
  Vec3 eye;                        // if orthographic: any point on the central ray
  Vec3 right, up, forward;         // unit
  float scale = 1;                 // pixels per stud; if perspective, at a distance of one stud
  float middleX = 0, middleY = 0;  // pixel of the forward direction
  bool perspective = true;

  // Returns x and y in pixels, and z as the distance along `forward` in studs, not positive behind
  // the eye.
  Vec3 project(Vec3 point) const;
  // Sets a ray whose direction has component 1 along `forward`, so origin + t * direction is at
  // distance t.
  void ray(float x, float y, Vec3& origin, Vec3& direction) const;
};

// Returns a camera along `forward` that shows all points with a margin, as large as possible.
// `points` must not be empty.
Camera framed(const std::vector<Vec3>& points, Vec3 forward, int width, int height,
              bool perspective);

}  // namespace obby::view
