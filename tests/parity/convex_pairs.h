// Random pairs of any two convex shapes at a chosen gap or depth along a chosen direction. Also
// returns the exact answer for pairs whose answer can be computed without iteration.
#pragma once

#include <memory>

#include "geom/separation.h"
#include "parity/hull.h"
#include "parity/pairs.h"

namespace obby::parity {

struct ConvexPair {
  geom::Convex a, b;
  // Precomputed faces of a hull (finding them is slow); null for other shapes.
  const Polytope* localA = nullptr;
  const Polytope* localB = nullptr;
};

inline std::string describe(const geom::Convex& c) {
  return describe(Pair{c.kind, c.shape, c.pose, {}}).substr(0, 200);
}

// Hulls with complete edges and without nearly parallel faces or edges.
class HullPool {
 public:
  HullPool(PairDice& dice, size_t count) {
    while (hulls_.size() < count) {
      std::vector<Vec3> points;
      const Vec3 size = dice.extents(0.05f, 10);
      const uint32_t corners = 4 + dice.random().below(7);
      for (uint32_t k = 0; k < corners; ++k) points.push_back(mul(dice.vec(1), size));
      auto hull = std::make_unique<TestHull>(points);
      const geom::ShapeData shape{size, &hull->hull};
      if (hull->tables.normals.empty() || hull->tables.edges.empty()) continue;
      Polytope exact = polytopeOf(geom::ShapeKind::hull, shape, {});
      if (hull->hasNearlyEqual(exact)) continue;
      hulls_.push_back(std::move(hull));
      polytopes_.push_back(std::make_unique<Polytope>(std::move(exact)));
      shapes_.push_back(shape);
    }
  }
  geom::ShapeData draw(PairDice& dice, const Polytope*& local) {
    const uint32_t i = dice.random().below(uint32_t(shapes_.size()));
    local = polytopes_[i].get();
    return {shapes_[i].half, &hulls_[i]->hull};
  }

 private:
  std::vector<std::unique_ptr<TestHull>> hulls_;
  std::vector<std::unique_ptr<Polytope>> polytopes_;
  std::vector<geom::ShapeData> shapes_;
};

class ConvexDice : public PairDice {
 public:
  explicit ConvexDice(uint64_t stream) : PairDice(stream), hulls_(*this, 200) {}

  geom::Convex convex(geom::ShapeKind kind, const Polytope*& local) {
    geom::Convex c{kind, {extents(0.025f, 25), nullptr}, {vec(8), rotation()}};
    if (kind == geom::ShapeKind::hull) c.shape = hulls_.draw(*this, local);
    if (random().below(4) == 0) c.pose.position = vec(3000);
    if (random().below(4) == 0) c.pose.rotation = standing();
    return c;
  }

  // Places b at a distance of `gap` from a. The two meet across a face of one of them, with a
  // random offset, or corner to corner in a random direction.
  void place(ConvexPair& p, float gap) {
    Vec3 d = direction(), aside{};
    const uint32_t choice = random().below(3);
    if (choice == 0 && geom::axes(p.a) > 0) d = faceOf(p.a);
    if (choice == 1 && geom::axes(p.b) > 0) d = faceOf(p.b);
    if (choice < 2) aside = vec(0.7f * minf(min(p.a.shape.half), min(p.b.shape.half)));
    // With a at the origin the computation loses no precision.
    const Vec3 at = p.a.pose.position;
    p.a.pose.position = p.b.pose.position = {};
    const Vec3 touching = geom::corner(p.a, d) - geom::corner(p.b, -d);
    p.a.pose.position = at;
    p.b.pose.position = at + touching + d * gap + (aside - d * dot(aside, d));
  }

  ConvexPair pair(geom::ShapeKind a, geom::ShapeKind b) {
    ConvexPair p{};
    p.a = convex(a, p.localA), p.b = convex(b, p.localB);
    if (random().below(4) == 0) p.b.pose.rotation = nearly(p.a.pose.rotation);
    place(p, gap());
    return p;
  }

 private:
  float gap() {
    switch (random().below(5)) {
      case 0: return -extents(1e-2f, 50).x;    // deep
      case 1: return -extents(1e-4f, 0.2f).x;  // shallow
      case 2: return between(-1e-5f, 1e-5f);   // touching
      case 3: return extents(1e-4f, 0.4f).x;   // just apart
      default: return -between(0, 0.5f);
    }
  }
  Vec3 faceOf(const geom::Convex& c) {
    const Vec3 n = geom::axis(c, int(random().below(uint32_t(geom::axes(c)))));
    return random().below(2) ? n : -n;
  }
  static float min(Vec3 v) { return minf(v.x, minf(v.y, v.z)); }

  HullPool hulls_;
};

inline Polytope polytopeOf(const geom::Convex& c, const Polytope* local) {
  return local ? moved(*local, c.pose) : polytopeOf(c.kind, c.shape, c.pose);
}

// Returns the signed distance of a point from a polytope. Every axis gives a lower bound. The axis
// that gives the exact distance is a face's normal, or points from an edge or a corner to the
// point.
inline double pointApart(const Polytope& p, const V3& at) {
  double best = -1e300;
  const auto test = [&](const V3& n) {
    if (n.norm() < 1e-9) return;
    const V3 unit = n.normalized();
    double max = -1e300;
    for (const V3& q : p.points) max = std::max(max, unit.dot(q));
    best = std::max(best, unit.dot(at) - max);
  };
  for (const V3& n : p.faces) test(n), test(-n);
  for (const V3& q : p.points) {
    test(at - q);
    for (const V3& e : p.edges) test(at - q - e * e.dot(at - q));
  }
  return best;
}

// Returns the signed distance of a point from a cylinder with any axis.
inline double pointApartOfCylinder(const geom::Convex& c, const V3& at) {
  const V3 d = at - wide(c.pose.position), axis = wide(c.pose.rotation.x).normalized();
  const double along = std::abs(d.dot(axis)) - double(c.shape.half.x);
  const double across =
      (d - axis * d.dot(axis)).norm() - double(minf(c.shape.half.y, c.shape.half.z));
  if (along < 0 || across < 0) return std::max(along, across);
  return std::hypot(along, across);
}

// Returns Bullet's overlap or distance of any two shapes.
inline BulletContact bulletApart(const geom::Convex& a, const geom::Convex& b) {
  const auto one = bulletShape(a.kind, a.shape), other = bulletShape(b.kind, b.shape);
  const Vec3 at = a.pose.position;
  const btTransform ta = bulletTransform(a.pose.rotation, {});
  const btTransform tb = bulletTransform(b.pose.rotation, b.pose.position - at);
  btGjkEpaSolver2::sResults results;
  const btVector3 guess = tb.getOrigin();
  if (btGjkEpaSolver2::Penetration(one.get(), ta, other.get(), tb, guess, results)) {
    return {true, -double(results.distance), {}};
  }
  const bool apart = btGjkEpaSolver2::Distance(one.get(), ta, other.get(), tb, guess, results);
  return {false, apart ? -double(results.distance) : 0.0, {}};
}

}  // namespace obby::parity
