// Fills by testing pixel centres. A shape smaller than a pixel still marks one.
#include "view/raster.h"

#include <algorithm>
#include <cmath>

namespace obby::view {
namespace {

constexpr Ink kEmpty{' ', " ", {18, 21, 28}};

float turn(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool inside(const std::vector<Vec2>& hull, Vec2 p) {
  for (size_t i = 0; i < hull.size(); ++i) {
    if (turn(hull[i], hull[(i + 1) % hull.size()], p) < 0) return false;
  }
  return true;
}

}  // namespace

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const size_t base = hull.size();
    for (const Vec2 p : points) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

Raster::Raster(Vec2 lo, Vec2 hi, size_t width, size_t maxRows,
               const table::TerminalTraits& terminal)
    : terminal_(terminal), halves_(terminal.color && terminal.utf8), lo_(lo) {
  const float spanX = std::max(hi.x - lo.x, 1.0f), spanY = std::max(hi.y - lo.y, 1.0f);
  const float tall = halves_ ? 1 : 2;  // height of a pixel, in widths of a pixel
  const size_t rows = halves_ ? 2 * maxRows : maxRows;
  const float size = std::max(spanX / float(width), spanY / float(rows) / tall);
  pixel_ = {size, size * tall};
  columns_ = std::clamp<size_t>(size_t(std::ceil(spanX / pixel_.x)), 1, width);
  rows_ = std::clamp<size_t>(size_t(std::ceil(spanY / pixel_.y)), 1, rows);
  if (halves_) rows_ += rows_ % 2;
  pixels_.assign(columns_ * rows_, kEmpty);
}

void Raster::put(long column, long row, const Ink& ink) {
  if (column < 0 || row < 0 || column >= long(columns_) || row >= long(rows_)) return;
  pixels_[size_t(row) * columns_ + size_t(column)] = ink;
}

void Raster::fill(const std::vector<Vec2>& hull, const Ink& ink) {
  if (hull.empty()) return;
  Vec2 lo = hull[0], hi = hull[0];
  for (const Vec2 p : hull) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  const auto column = [&](float x) {
    return std::lround(std::clamp((x - lo_.x) / pixel_.x, -2.0f, float(columns_) + 2) - 0.5f);
  };
  const auto row = [&](float y) {
    return std::lround(std::clamp((y - lo_.y) / pixel_.y, -2.0f, float(rows_) + 2) - 0.5f);
  };
  dot({(lo.x + hi.x) / 2, (lo.y + hi.y) / 2}, ink);
  if (hull.size() < 3) return;
  for (long r = row(lo.y); r <= row(hi.y); ++r) {
    for (long c = column(lo.x); c <= column(hi.x); ++c) {
      const Vec2 centre{lo_.x + (float(c) + 0.5f) * pixel_.x, lo_.y + (float(r) + 0.5f) * pixel_.y};
      if (inside(hull, centre)) put(c, r, ink);
    }
  }
}

void Raster::dot(Vec2 at, const Ink& ink) {
  const float c = std::floor((at.x - lo_.x) / pixel_.x), r = std::floor((at.y - lo_.y) / pixel_.y);
  if (!(std::fabs(c) < 1e6f && std::fabs(r) < 1e6f)) return;
  put(long(c), long(r), ink);
}

void Raster::line(Vec2 a, Vec2 b, const Ink& ink) {
  const float far = std::max(std::fabs(b.x - a.x) / pixel_.x, std::fabs(b.y - a.y) / pixel_.y);
  const int steps = int(std::clamp(std::ceil(far * 2), 1.0f, 4000.0f));
  for (int i = 0; i <= steps; ++i) {
    const float t = float(i) / float(steps);
    dot({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}, ink);
  }
}

std::string Raster::coloredRow(size_t row) const {
  std::string out;
  table::Rgb front{}, back{};
  bool first = true;
  for (size_t c = 0; c < columns_; ++c) {
    const table::Rgb top = pixels_[row * columns_ + c].color;
    const table::Rgb low = pixels_[(row + 1) * columns_ + c].color;
    if (first || !(top == front) || !(low == back)) {
      out += table::colorSequence(table::Layer::front, top, terminal_);
      out += table::colorSequence(table::Layer::back, low, terminal_);
    }
    front = top;
    back = low;
    first = false;
    out += "▀";
  }
  return out + "\x1b[0m\n";
}

std::string Raster::plainRow(size_t row) const {
  std::string out;
  size_t end = 0;  // after the last glyph that is not empty
  for (size_t c = 0; c < columns_; ++c) {
    const Ink& ink = pixels_[row * columns_ + c];
    out += terminal_.utf8 ? std::string(ink.wide) : std::string(1, ink.glyph);
    if (ink.glyph != ' ') end = out.size();
  }
  return out.substr(0, end) + "\n";
}

std::string Raster::text() const {
  std::string out;
  for (size_t row = 0; row < rows_; row += halves_ ? 2 : 1) {
    out += halves_ ? coloredRow(row) : plainRow(row);
  }
  return out;
}

}  // namespace obby::view
