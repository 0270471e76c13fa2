#include "view/picture/picture.h"

#include <algorithm>
#include <cmath>

#include "level/record_values.h"
#include "view/extent.h"
#include "view/picture/pen.h"
#include "view/picture/shade.h"
#include "view/picture/view_choice.h"
#include "view/picture/world.h"

namespace obby::view {

namespace {

constexpr int kSamples = 2;        // per pixel, each axis
constexpr int kSunSamples = 2048;  // each axis
constexpr float kAboveFeet = 1;    // studs: trajectories run through the body, not along the floor
constexpr float kVeil = 0.16f;

constexpr Rgb kSolutionPaint{255, 184, 28}, kOtherSolutionPaint{214, 160, 60},
    kAttemptPaint{120, 78, 60}, kDeathPaint{200, 30, 36}, kStartPaint{24, 140, 92},
    kGoalPaint{40, 110, 235}, kAvoidPaint{176, 40, 150}, kWaypointPaint{190, 130, 10};

Rgb regionColor(RegionKind kind) {
  switch (kind) {
    case RegionKind::avoid: return kAvoidPaint;
    case RegionKind::goal: return kGoalPaint;
    default: return kWaypointPaint;
  }
}

std::vector<Vec3> feetOf(const Playback& play) {
  std::vector<Vec3> out;
  for (const Vec3 feet : play.feet) out.push_back(feet + Vec3{0, kAboveFeet, 0});
  return out;
}

void drawPath(Pen& pen, const PathEntry& path, bool first) {
  const bool solves = path.kind == PathKind::solution;
  const Stroke stroke{colorOf(first    ? kSolutionPaint
                              : solves ? kOtherSolutionPaint
                                       : kAttemptPaint),
                      first    ? 7.0f
                      : solves ? 4.0f
                               : 2.5f,
                      solves ? 1 : 0.4f};
  const std::vector<Vec3> trajectory = feetOf(path.playback);
  if (first) {
    Stroke under = stroke;
    under.color = {0, 0, 0};
    under.width = 11;
    under.opacity = 0.5f;
    pen.line(trajectory, under);
  }
  pen.line(trajectory, stroke);
  if (!solves && path.playback.outcome != schema::Outcome::RUNNING)
    pen.cross(trajectory.back(), 7, {colorOf(kDeathPaint), 4, 0.9f});
  if (!first) return;
  for (const uint32_t tick : path.playback.jumpTicks) {
    const size_t at = std::min<size_t>(tick, trajectory.size() - 1);
    pen.disc(trajectory[at], 7, {{0, 0, 0}, 1, 0.8f});
    pen.disc(trajectory[at], 5, {{1, 1, 1}, 1, 1});
  }
}

void drawRegions(Pen& pen, const QueryEntry& query) {
  forRegions(query.reader(), [&](schema::Region::Reader record, RegionKind kind) {
    const auto region = level::region(record, "");
    if (!region) return;
    Solid box;
    box.pose = region->pose;
    box.shape.half = region->half;
    pen.box(box, {colorOf(regionColor(kind)), 3, 0.9f, 0.35f}, kVeil);
  });
}

void drawQuery(Pen& pen, const QueryEntry& query, bool attempts) {
  if (query.query) drawRegions(pen, query);
  for (const PathEntry& path : query.paths) {
    if (path.kind == PathKind::attempt && !attempts) continue;
    if (path.kind != PathKind::solution) drawPath(pen, path, false);
  }
  // The first solution is drawn last, on top.
  for (size_t i = query.paths.size(); i-- > 0;) {
    if (query.paths[i].kind == PathKind::solution) drawPath(pen, query.paths[i], i == 0);
  }
  if (!query.compiled) return;
  const Vec3 start = query.compiled->start().feet + Vec3{0, kAboveFeet, 0};
  pen.disc(start, 13, {{0, 0, 0}, 1, 0.6f});
  pen.disc(start, 10, {colorOf(kStartPaint), 1, 1});
}

// Adds the pixels of `rows` rows from their samples.
void addRows(const std::vector<Color>& samples, int rows, Image& out) {
  const int width = out.width;
  const float share = 1.0f / (kSamples * kSamples);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < width; ++x) {
      Color sum;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const Color& c = samples[size_t(y * kSamples + k / kSamples) * size_t(width * kSamples) +
                                 size_t(x * kSamples + k % kSamples)];
        sum = {sum.r + c.r * share, sum.g + c.g * share, sum.b + c.b * share};
      }
      out.pixels.push_back(rgbOf(sum));
    }
  }
}

struct Scene {
  const World& world;
  const QueryEntry* query;  // may be null
  const Camera& camera;
  const Depths& sun;
  bool attempts;
};

// Draws the rows of pixels from `top` to `bottom`, which is exclusive.
void drawRows(const Scene& scene, int top, int bottom, Image& out) {
  const int width = out.width * kSamples, height = out.height * kSamples;
  // One more row of samples detects the solids' edges in the row above it.
  const Samples window{0, top * kSamples, width, std::min(bottom * kSamples + 1, height)};
  Depths seen(scene.camera, width, height, window);
  for (uint32_t i = 0; i < scene.world.solids.size(); ++i) seen.add(scene.world.solids[i], i);
  std::vector<Color> colors = shade(seen, scene.sun, scene.world.surfaces);
  Pen pen(seen, colors);
  if (scene.query) drawQuery(pen, *scene.query, scene.attempts);
  addRows(colors, bottom - top, out);
}

}  // namespace

Image pictureOf(const LevelEntry& level, const QueryEntry* query, const PictureOptions& options) {
  const Subject subject = subjectOf(level, query);
  const uint32_t tick = query && query->compiled ? query->compiled->start().tick : 0;
  const World world = worldOf(level, tick);
  const int width = options.width * kSamples, height = options.height * kSamples;
  const Vec3 look = bestLook(subject, world.solids, options.width, options.height);
  const Camera camera = framed(subject.frame, look, width, height, true);
  Depths sun(framed(subject.frame, -sunward(), kSunSamples, kSunSamples, false), kSunSamples,
             kSunSamples);
  for (uint32_t i = 0; i < world.solids.size(); ++i) {
    if (world.solids[i].coverage > 0.5f) sun.add(world.solids[i], i);
  }
  Image out{options.width, options.height, {}};
  out.pixels.reserve(size_t(options.width) * size_t(options.height));
  const size_t row = size_t(width) * kSamples;  // samples in a row of pixels
  const int rows = int(std::clamp<size_t>(options.atOnce / row, 1, size_t(options.height)));
  for (int top = 0; top < options.height; top += rows)
    drawRows({world, query, camera, sun, options.attempts}, top,
             std::min(top + rows, options.height), out);
  return out;
}

}  // namespace obby::view
