// Finds where a player could stand: points on the upward faces of the level's solid parts, found by
// casting rays down on a grid over each part, points inside trusses, which can be hung on at any
// height, parts without collision that do something when touched, and a uniform grid over them to
// look up near ones. Host only.
#pragma once

#include <vector>

#include "solve/search/rollouts/surface_view.h"

namespace obby::solve {

class Surfaces {
 public:
  explicit Surfaces(const level::LevelView& level);
  SurfaceView view() const;  // valid while this object lives
  size_t pointCount() const { return points_.size(); }
  const std::vector<SurfacePoint>& points() const { return points_; }

 private:
  void samplePart(const level::LevelView& level, uint32_t collider);
  void addTouchTarget(const level::LevelView& level, uint32_t collider);
  void addPoint(const level::LevelView& level, uint32_t collider, const Pose& pose, Vec3 point);
  void buildGrid();

  std::vector<SurfacePoint> points_;
  std::vector<Box> reach_;  // (points), where each can be
  std::vector<uint32_t> entries_, starts_;
  Vec3 origin_;
  float width_ = 4, height_ = 8;
  int32_t nx_ = 1, ny_ = 1, nz_ = 1;
};

}  // namespace obby::solve
