// The orthographic projection of a drawing.
#pragma once

#include "view/raster.h"

namespace obby::view {

constexpr float kPaperMargin = 12;  // pixels

// Maps the world to paper. Pixels: x to the right, y down.
struct Paper {
  Vec3 across, down;  // unit vectors in world axes
  float scale = 1;    // pixels per stud
  Vec2 origin;        // paper coordinates of the upper left corner, studs

  Vec2 of(Vec3 v) const {
    return {(dot(v, across) - origin.x) * scale + kPaperMargin,
            (dot(v, down) - origin.y) * scale + kPaperMargin};
  }
  Vec3 toward() const { return -cross(across, -down); }  // the viewing direction
  // Returns the point of the plane through the world's origin that is seen at a pixel.
  Vec3 at(Vec2 pixel) const {
    return across * ((pixel.x - kPaperMargin) / scale + origin.x) +
           down * ((pixel.y - kPaperMargin) / scale + origin.y);
  }
};

}  // namespace obby::view
