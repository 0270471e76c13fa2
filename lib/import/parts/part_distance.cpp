// Computes distances in a grid. Squares covered by parts are 0; two sweeps carry the distances from
// square to square (5 to the next one, 7 across a corner).
#include "import/parts/part_distance.h"

#include <algorithm>
#include <cmath>

namespace obby::importer {
namespace {

// Max squares along the longer side; min side of a square, in studs.
constexpr float kSquares = 256, kMinSquare = 32;
constexpr int kToNextSquare = 5, kToCorner = 7, kUnknownDistance = 1 << 28;

size_t squareOf(float at, float from, float step, size_t count) {
  const float square = std::floor((at - from) / step);
  return size_t(std::clamp(square, 0.0f, float(count - 1)));
}

}  // namespace

PartDistance::PartDistance(const std::vector<PartDraft>& parts, GroundArea whole) : whole_(whole) {
  const float width = whole.x1 - whole.x0, depth = whole.z1 - whole.z0;
  step_ = std::max(kMinSquare, std::max(width, depth) / kSquares);
  width_ = size_t(width / step_) + 1;
  depth_ = size_t(depth / step_) + 1;
  distances_.assign(width_ * depth_, kUnknownDistance);
  for (const PartDraft& part : parts) {
    const Box box = boundsOf(part.pose, part.size * 0.5f);
    const Span span = spanOf({box.lo.x, box.hi.x, box.lo.z, box.hi.z});
    for (size_t z = span.z0; z <= span.z1; ++z)
      std::fill_n(distances_.begin() + std::ptrdiff_t(z * width_ + span.x0), span.x1 - span.x0 + 1,
                  0);
  }
  spread();
}

PartDistance::Span PartDistance::spanOf(const GroundArea& area) const {
  return {squareOf(area.x0, whole_.x0, step_, width_), squareOf(area.x1, whole_.x0, step_, width_),
          squareOf(area.z0, whole_.z0, step_, depth_), squareOf(area.z1, whole_.z0, step_, depth_)};
}

void PartDistance::spread() {
  const auto sweep = [&](bool back) {
    const int side = back ? 1 : -1;
    const auto width = int(width_), depth = int(depth_);
    const auto at = [&](int x, int z) { return distances_[size_t(z) * width_ + size_t(x)]; };
    for (int i = 0; i < width * depth; ++i) {
      const int square = back ? width * depth - 1 - i : i;
      const int x = square % width, z = square / width;
      int& best = distances_[size_t(square)];
      const int nextX = x + side, nextZ = z + side;
      if (nextX >= 0 && nextX < width) best = std::min(best, at(nextX, z) + kToNextSquare);
      if (nextZ < 0 || nextZ >= depth) continue;
      best = std::min(best, at(x, nextZ) + kToNextSquare);
      if (x > 0) best = std::min(best, at(x - 1, nextZ) + kToCorner);
      if (x + 1 < width) best = std::min(best, at(x + 1, nextZ) + kToCorner);
    }
  };
  sweep(false);
  sweep(true);
}

float PartDistance::of(const GroundArea& area) const {
  const Span span = spanOf(area);
  int best = kUnknownDistance;
  for (size_t z = span.z0; z <= span.z1; ++z)
    for (size_t x = span.x0; x <= span.x1; ++x) best = std::min(best, distances_[z * width_ + x]);
  return float(best) * step_ / float(kToNextSquare);
}

}  // namespace obby::importer
