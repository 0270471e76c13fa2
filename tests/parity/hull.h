// A convex hull of points, with its exact polytope and the level compiler's tables for it.
#pragma once

#include "level/hull_tables.h"
#include "parity/exact.h"

namespace obby::parity {

struct TestHull {
  explicit TestHull(const std::vector<Vec3>& points)
      : tables(level::hullTables(points)), hull(level::viewOf(tables)) {}
  TestHull(const TestHull&) = delete;
  TestHull& operator=(const TestHull&) = delete;

  // Returns true if two faces, or two edges, are within a third of a degree of each other.
  bool hasNearlyEqual(const Polytope& exact) const {
    return anyClose(exact.faces) || anyClose(exact.edges);
  }

  level::HullTables tables;
  geom::Hull hull;

 private:
  static bool anyClose(const std::vector<V3>& directions) {
    for (size_t a = 0; a < directions.size(); ++a) {
      for (size_t b = 0; b < a; ++b) {
        if (std::abs(directions[a].dot(directions[b])) > 1 - 2e-5) return true;
      }
    }
    return false;
  }
};

}  // namespace obby::parity
