#include "level/compile_hulls.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "level/part_numbers.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

// Hulls with more corners are replaced by the box around them, because the work is cubic in the
// number of corners.
constexpr size_t kMaxThickened = 64;

Result<std::vector<Vec3>> verticesOf(schema::Hull::Reader record, const std::string& path) {
  std::vector<Vec3> vertices;
  for (const auto v : record.getVertices()) {
    OBBY_ASSIGN(const Vec3 at, position(v, path));
    vertices.push_back(at);
  }
  if (vertices.size() < 4 || vertices.size() > kMaxHullVertices) {
    return pathError(path, fmt::format("expected 4 to {} vertices, found {}", kMaxHullVertices,
                                       vertices.size()));
  }
  return vertices;
}

// Returns copies of flat vertices on both sides of their plane, kMinSize apart. The vertices must
// be flat along exactly one axis; otherwise returns none.
std::vector<Vec3> thickened(const std::vector<Vec3>& vertices) {
  Vec3 lo = vertices[0], hi = lo;
  for (const Vec3 p : vertices) lo = min(lo, p), hi = max(hi, p);
  const Vec3 extent = hi - lo;
  const auto isFlat = [&](int axis) { return component(extent, axis) < kMinSize; };
  if (int(isFlat(0)) + int(isFlat(1)) + int(isFlat(2)) != 1) return {};
  const Vec3 across{isFlat(0) ? 1.f : 0.f, isFlat(1) ? 1.f : 0.f, isFlat(2) ? 1.f : 0.f};
  const Vec3 half = across * (0.5f * kMinSize), middle = (lo + hi) * 0.5f;
  std::vector<Vec3> thick;
  for (const Vec3 p : vertices.size() > kMaxThickened ? boxAround(vertices) : vertices) {
    const Vec3 flat = p - across * dot(across, p - middle);
    thick.push_back(flat - half);
    thick.push_back(flat + half);
  }
  return thick;
}

}  // namespace

Result<std::vector<const geom::Hull*>> hullsOf(schema::Part::Reader part, HullStore& store) {
  std::vector<const geom::Hull*> hulls;
  std::vector<std::vector<Vec3>> flat;
  size_t index = 0;
  for (const auto record : part.getHulls()) {
    OBBY_ASSIGN(std::vector<Vec3> vertices,
                verticesOf(record, fmt::format("hulls[{}].vertices", index++)));
    const geom::Hull* const hull = store.hullOf(vertices);
    if (hull != nullptr) hulls.push_back(hull);
    if (hulls.empty()) flat.push_back(std::move(vertices));
  }
  if (!hulls.empty()) return hulls;
  for (const std::vector<Vec3>& vertices : flat) {
    const std::vector<Vec3> thick = thickened(vertices);
    const geom::Hull* const hull = thick.empty() ? nullptr : store.hullOf(thick);
    if (hull != nullptr) hulls.push_back(hull);
  }
  return hulls;
}

}  // namespace obby::level
