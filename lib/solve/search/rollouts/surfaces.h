// Finds the places where a player could stand, and puts them into a uniform grid. Rays cast down on
// a grid over each solid part find points on its upward faces. Points inside trusses count, too,
// since players can climb at any height. So do points of parts without collision that act when
// touched. Host only.
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
  std::vector<Box> reach_;  // (points), bounds of each point's positions
  std::vector<uint32_t> entries_, starts_;
  Vec3 origin_;
  float width_ = 4, height_ = 8;
  int32_t nx_ = 1, ny_ = 1, nz_ = 1;
};

}  // namespace obby::solve
