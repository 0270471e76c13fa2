// A picture in progress: id, depth and normal of the visible solid for each sample, and colours.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"
#include "table/terminal.h"
#include "view/picture/camera.h"

namespace obby::view {

using table::Rgb;

// Components of the sRGB values in files, 0 to 1; not linear light.
struct Color {
  float r = 0, g = 0, b = 0;
};
Color colorOf(Rgb c);
Rgb rgbOf(Color c);
Color mix(Color a, Color b, float share);  // `share`: weight of b

// A convex shape at its current pose.
struct Solid {
  Pose pose;
  geom::ShapeKind kind = geom::ShapeKind::block;
  geom::ShapeData shape;
  float coverage = 1;  // share of samples covered; below 1 the solid looks translucent
};

constexpr uint32_t kNothing = 0xffffffffu;

// A rectangle of samples; x1 and y1 are exclusive.
struct Samples {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

// A depth buffer of a whole picture or of a window of it, which limits the memory. Coordinates are
// the picture's.
class Depths {
 public:
  Depths(const Camera& camera, int width, int height)
      : Depths(camera, width, height, {0, 0, width, height}) {}
  // `window` lies within the picture. Samples outside must not be accessed.
  Depths(const Camera& camera, int width, int height, const Samples& window);

  // Returns the samples of the window that may see the solid.
  Samples samplesOf(const Solid& solid) const;
  // `id`: value for the samples that see the solid.
  void add(const Solid& solid, uint32_t id);

  int width() const { return width_; }  // width of the picture
  int height() const { return height_; }
  const Samples& window() const { return window_; }
  // Returns a sample's index within the window, row by row.
  size_t at(int x, int y) const {
    return size_t(y - window_.y0) * size_t(window_.x1 - window_.x0) + size_t(x - window_.x0);
  }
  const Camera& camera() const { return camera_; }
  uint32_t id(int x, int y) const { return ids_[at(x, y)]; }
  float depth(int x, int y) const { return depths_[at(x, y)]; }  // studs; a huge value for none
  Vec3 normal(int x, int y) const { return normals_[at(x, y)]; }
  Vec3 point(int x, int y) const;  // in world space

 private:
  Camera camera_;
  int width_, height_;
  Samples window_;
  std::vector<float> depths_;
  std::vector<uint32_t> ids_;
  std::vector<Vec3> normals_;
};

// Pixels, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

}  // namespace obby::view
