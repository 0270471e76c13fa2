// Lines, marks and boxes over a shaded picture. Parts of them behind a solid are faint.
#pragma once

#include <vector>

#include "view/picture/canvas.h"

namespace obby::view {

struct Stroke {
  Color color;
  float width = 2;  // samples
  float opacity = 1;
  float behind = 0.25f;  // factor of the opacity behind a nearer solid
};

class Pen {
 public:
  // Draws into `colors`, one for each sample in the window of `seen`. Other samples are left out.
  Pen(const Depths& seen, std::vector<Color>& colors);

  // Draws a line through world points. It is no darker where it crosses itself.
  void line(const std::vector<Vec3>& points, const Stroke& stroke);
  // Draw a cross or a disc that extends `size` samples to each side.
  void cross(Vec3 at, float size, const Stroke& stroke);
  void disc(Vec3 at, float size, const Stroke& stroke);
  // Draws an oriented box: its edges, and its inside with opacity `veil`.
  void box(const Solid& box, const Stroke& stroke, float veil);

 private:
  void begin() { ++stroke_; }
  void segment(Vec3 a, Vec3 b, const Stroke& stroke);  // projected
  void fill(const Solid& box, const Stroke& stroke);
  void put(int x, int y, float depth, const Stroke& stroke);

  const Depths& seen_;
  std::vector<Color>& colors_;
  std::vector<uint32_t> strokes_;  // last stroke that touched each sample
  uint32_t stroke_ = 0;
};

}  // namespace obby::view
