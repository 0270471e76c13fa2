// Lines, marks and boxes drawn over a shaded picture; what lies behind a solid shows faintly.
#pragma once

#include <vector>

#include "view/picture/canvas.h"

namespace obby::view {

struct Stroke {
  Color color;
  float width = 2;  // samples
  float opacity = 1;
  float behind = 0.25f;  // of the opacity, where a solid is nearer
};

class Pen {
 public:
  // `colors`: of the samples of the window of `seen`; drawn into. What is elsewhere is left out.
  Pen(const Depths& seen, std::vector<Color>& colors);

  // Through points of the world. Where it crosses itself it is no darker.
  void line(const std::vector<Vec3>& points, const Stroke& stroke);
  // A cross, or a disc, of so many samples to each side.
  void cross(Vec3 at, float size, const Stroke& stroke);
  void disc(Vec3 at, float size, const Stroke& stroke);
  // An oriented box: its edges, and its inside as a veil.
  void box(const Solid& box, const Stroke& stroke, float veil);

 private:
  void begin() { ++stroke_; }
  void segment(Vec3 a, Vec3 b, const Stroke& stroke);  // projected
  void fill(const Solid& box, const Stroke& stroke);
  void put(int x, int y, float depth, const Stroke& stroke);

  const Depths& seen_;
  std::vector<Color>& colors_;
  std::vector<uint32_t> strokes_;  // the last stroke that has touched a sample
  uint32_t stroke_ = 0;
};

}  // namespace obby::view
