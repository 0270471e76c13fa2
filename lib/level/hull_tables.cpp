// Selects the vertices that a hull keeps, and finds the faces of hulls that are thin for their
// width.
#include "level/hull_tables.h"

#include <algorithm>
#include <array>
#include <utility>

#include "level/hull_faces.h"

namespace obby::level {
namespace {

constexpr float kTolerance = 1e-4f;  // share of the hull's size

// Thinner hulls are dropped, including flat ones. Rounding leaves these slivers in a union, and
// they are not floors.
constexpr float kThinnest = 0.01f;  // studs
// Share of the hull's size, about the precision of its vertices.
constexpr float kThinnestShare = 2e-6f;

std::vector<Vec3> distinct(const std::vector<Vec3>& points, float tolerance) {
  std::vector<Vec3> out;
  for (const Vec3 p : points) {
    bool fresh = true;
    for (const Vec3 q : out) fresh = fresh && length(p - q) > tolerance;
    if (fresh) out.push_back(p);
  }
  return out;
}

// Returns the tables of a hull that is not much wider than thick, otherwise empty normals.
HullTables solidTables(const std::vector<Vec3>& vertices) {
  float size = 0;
  for (const Vec3 p : vertices) size = maxf(size, length(p - vertices[0]));
  const float tolerance = size * kTolerance;
  HullTables hull;
  hull.vertices = distinct(vertices, tolerance);
  findFaces(hull, size, tolerance);
  return hull;
}

// An affine map that makes a thin hull as thick as it is wide, so that its faces can be found.
class Stretch {
 public:
  explicit Stretch(const std::vector<Vec3>& vertices) {
    const std::array<Vec3, 3> t = largestTriangle(vertices);
    Vec3 longest = t[1] - t[0];
    for (const Vec3 side : {t[2] - t[0], t[2] - t[1]}) {
      if (length(side) > length(longest)) longest = side;
    }
    axes_[2] = normalize(cross(t[1] - t[0], t[2] - t[0]));
    axes_[0] = normalize(longest);
    axes_[1] = cross(axes_[2], axes_[0]);
    for (size_t k = 0; k < 3; ++k) {
      double lo = along(k, vertices[0]), hi = lo;
      for (const Vec3 p : vertices) lo = std::min(lo, along(k, p)), hi = std::max(hi, along(k, p));
      middle_[k] = (lo + hi) / 2, half_[k] = (hi - lo) / 2;
    }
  }

  // Returns the smallest extent along its axes, studs.
  double thickness() const { return 2 * std::min({half_[0], half_[1], half_[2]}); }

  // Maps the hull to the range -1 to 1 along each axis.
  Vec3 stretched(Vec3 p) const {
    const auto at = [&](size_t k) { return float((along(k, p) - middle_[k]) / half_[k]); };
    return {at(0), at(1), at(2)};
  }

  // These map the normal of a face and the direction of an edge back.
  Vec3 normal(Vec3 n) const { return back(n, {1 / half_[0], 1 / half_[1], 1 / half_[2]}); }
  Vec3 edge(Vec3 e) const { return back(e, half_); }

 private:
  static std::array<Vec3, 3> largestTriangle(const std::vector<Vec3>& v) {
    std::array<Vec3, 3> largest{v[0], v[0], v[0]};
    float limit = 0, maxSquare = 0;
    for (size_t a = 0; a < v.size(); ++a) {
      for (size_t b = a + 1; b < v.size(); ++b) {
        for (size_t c = b + 1; c < v.size(); ++c) {
          const Vec3 across = cross(v[b] - v[a], v[c] - v[a]);
          const float square = dot(across, across);
          if (square <= maxSquare) continue;  // saves the square root, which is slower
          maxSquare = square;
          const float area = length(across);
          if (area > limit) limit = area, largest = {v[a], v[b], v[c]};
        }
      }
    }
    return largest;
  }

  // Uses doubles: far from the origin, floats are coarser than the thickness of a thin hull.
  double along(size_t k, Vec3 p) const {
    const Vec3 a = axes_[k];
    return double(a.x) * double(p.x) + double(a.y) * double(p.y) + double(a.z) * double(p.z);
  }

  Vec3 back(Vec3 v, const std::array<double, 3>& scale) const {
    Vec3 sum;
    for (size_t k = 0; k < 3; ++k) sum += axes_[k] * float(component(v, int(k)) * scale[k]);
    return normalize(sum);
  }

  std::array<Vec3, 3> axes_;
  std::array<double, 3> middle_{}, half_{};
};

// Returns the min and max of the vertices along a direction, studs.
std::pair<float, float> reachAlong(Vec3 n, const std::vector<Vec3>& vertices) {
  float lo = dot(n, vertices[0]), hi = lo;
  for (const Vec3 p : vertices) lo = minf(lo, dot(n, p)), hi = maxf(hi, dot(n, p));
  return {lo, hi};
}

// Returns the tables of a needle, or of a hull that is thin for its width. Players must not fall
// through wide floors.
HullTables thinTables(const std::vector<Vec3>& vertices) {
  const Stretch map(vertices);
  float size = 0;
  for (const Vec3 p : vertices) size = maxf(size, length(p - vertices[0]));
  const float thinnest = maxf(kThinnest, size * kThinnestShare);
  if (!(map.thickness() > 0.5 * double(thinnest))) return {};
  std::vector<Vec3> stretched;
  for (const Vec3 p : vertices) stretched.push_back(map.stretched(p));
  const HullTables solid = solidTables(stretched);
  HullTables hull;
  for (const Vec3 p : solid.vertices) {
    const auto same = std::find(stretched.begin(), stretched.end(), p);
    hull.vertices.push_back(vertices[size_t(same - stretched.begin())]);
  }
  for (const Vec3 n : solid.normals) {
    const Vec3 normal = map.normal(n);
    const auto [lo, hi] = reachAlong(normal, hull.vertices);
    if (hi - lo < thinnest) return {};
    hull.normals.push_back(normal);
    hull.offsets.push_back(hi);
  }
  for (const Vec3 e : solid.edges) hull.edges.push_back(map.edge(e));
  return hull;
}

// Returns true if the faces do not enclose a bounded volume. This happens if the ends of a long
// beam are too small for faces of their own. Rays would then meet it beyond its ends.
bool isOpen(const HullTables& hull) {
  const auto leadsOut = [&](Vec3 d) {
    return std::all_of(hull.normals.begin(), hull.normals.end(),
                       [&](Vec3 n) { return dot(n, d) < 1e-4f; });
  };
  for (size_t i = 0; i < hull.normals.size(); ++i) {
    for (size_t j = i + 1; j < hull.normals.size(); ++j) {
      const Vec3 d = cross(hull.normals[i], hull.normals[j]);
      if (length(d) > 1e-3f && (leadsOut(normalize(d)) || leadsOut(-normalize(d)))) return true;
    }
  }
  return false;
}

}  // namespace

HullTables hullTables(const std::vector<Vec3>& vertices) {
  HullTables hull = solidTables(vertices);
  if (!hull.normals.empty() && !isOpen(hull)) return hull;
  HullTables thin = thinTables(vertices);
  return thin.normals.empty() ? hull : thin;
}

std::vector<Vec3> boxAround(const std::vector<Vec3>& points) {
  Vec3 lo = points.front(), hi = lo;
  for (const Vec3 p : points) lo = min(lo, p), hi = max(hi, p);
  std::vector<Vec3> box;
  for (const float x : {lo.x, hi.x})
    for (const float y : {lo.y, hi.y})
      for (const float z : {lo.z, hi.z}) box.push_back({x, y, z});
  return box;
}

geom::Hull viewOf(const HullTables& t) {
  return {t.vertices.data(),
          t.normals.data(),
          t.offsets.data(),
          t.edges.data(),
          uint32_t(t.vertices.size()),
          uint32_t(t.normals.size()),
          uint32_t(t.edges.size())};
}

const geom::Hull* HullStore::hullOf(const std::vector<Vec3>& vertices) {
  const auto* const bytes = reinterpret_cast<const char*>(vertices.data());
  const auto [known, isNew] =
      known_.try_emplace(std::string(bytes, vertices.size() * sizeof(Vec3)), nullptr);
  if (!isNew) return known->second;
  HullTables tables = hullTables(vertices);
  if (tables.normals.empty()) return nullptr;
  tables_.push_back(std::move(tables));
  views_.push_back(viewOf(tables_.back()));
  known->second = &views_.back();
  return known->second;
}

}  // namespace obby::level
