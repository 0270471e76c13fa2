// A convex shape of any kind at a world pose, with the functions that tests between two shapes use.
#pragma once

#include "geom/shapes/table.h"

namespace obby::geom {

struct Convex {
  ShapeKind kind;
  ShapeData shape;
  Pose pose;
};

OBBY_DEVICE bool isRound(ShapeKind kind) {
  return kind == ShapeKind::ball || kind == ShapeKind::cylinder;
}
OBBY_DEVICE bool isBlock(ShapeKind kind) {
  return kind == ShapeKind::block || kind == ShapeKind::truss;
}

// Returns the largest dot(d, p) over the points p of the shape.
OBBY_APART float support(const Convex& c, Vec3 d) {
  const Vec3 local = toLocal(c.pose.rotation, d);
  const float own =
      visitShape(c.kind, [&](auto s) { return decltype(s)::support(c.shape, local); });
  return own + dot(d, c.pose.position);
}

OBBY_APART Vec3 corner(const Convex& c, Vec3 d) {
  const Vec3 local = toLocal(c.pose.rotation, d);
  return toWorld(c.pose,
                 visitShape(c.kind, [&](auto s) { return decltype(s)::corner(c.shape, local); }));
}

OBBY_APART int feature(const Convex& c, Vec3 d, Vec3* out) {
  const Vec3 local = toLocal(c.pose.rotation, d);
  const int count =
      visitShape(c.kind, [&](auto s) { return decltype(s)::feature(c.shape, local, out); });
  for (int i = 0; i < count; ++i) out[i] = toWorld(c.pose, out[i]);
  return count;
}

OBBY_DEVICE int axes(const Convex& c) {
  return visitShape(c.kind, [&](auto s) { return decltype(s)::axes(c.shape); });
}
OBBY_APART Vec3 axis(const Convex& c, int i) {
  return c.pose.rotation *
         visitShape(c.kind, [&](auto s) { return decltype(s)::axis(c.shape, i); });
}
OBBY_DEVICE int edges(const Convex& c) {
  return visitShape(c.kind, [&](auto s) { return decltype(s)::edges(c.shape); });
}
OBBY_APART Vec3 edge(const Convex& c, int i) {
  return c.pose.rotation *
         visitShape(c.kind, [&](auto s) { return decltype(s)::edge(c.shape, i); });
}

}  // namespace obby::geom
