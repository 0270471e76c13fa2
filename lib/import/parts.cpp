// From the properties of a part to its collision shape and surface.
#include "import/parts.h"

#include <algorithm>
#include <cmath>

#include "import/format/class_defaults.h"
#include "import/format/csg_physics.h"
#include "import/materials.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

struct ClassShape {
  std::string_view className;
  Shape shape;
};
constexpr ClassShape kClassShapes[] = {{"WedgePart", Shape::wedge},
                                       {"CornerWedgePart", Shape::cornerWedge},
                                       {"TrussPart", Shape::truss},
                                       {"TriangleMeshPart", Shape::hull}};
// By the value of the PartType enum.
constexpr Shape kPartTypes[] = {Shape::ball, Shape::block, Shape::cylinder, Shape::wedge,
                                Shape::cornerWedge};

constexpr size_t kLeastCorners = 4, kMostCorners = 255;

Shape shapeOf(const Instance& instance) {
  for (const auto& row : kClassShapes)
    if (isA(instance.className, row.className)) return row.shape;
  if (!isA(instance.className, "Part")) return Shape::block;
  const uint32_t type = get<EnumItem>(instance, "Shape").value;
  return type < std::size(kPartTypes) ? kPartTypes[type] : Shape::block;
}

// Files may hold anything: NaN becomes the fallback, other numbers are brought into range.
float within(double value, float low, float high, float fallback) {
  return std::isnan(value) ? fallback : float(std::clamp(value, double(low), double(high)));
}

void setSurface(const Instance& instance, PartDraft& part) {
  auto physical = get<PhysicalProperties>(instance, "CustomPhysicalProperties");
  const uint32_t material = get<EnumItem>(instance, "Material").value;
  if (!physical.custom) physical = materialProperties(material);
  part.material = materialName(material);
  part.density = within(physical.density, 1e-4f, 100, part.density);
  part.friction = within(physical.friction, 0, 2, part.friction);
  part.elasticity = within(physical.elasticity, 0, 1, part.elasticity);
  part.color = get<ColorRgb>(instance, "Color");
  part.transparency = within(get<double>(instance, "Transparency"), 0, 1, 0);
}

// Unions and meshes: their hulls where the file has them, else their box.
void setHulls(const Tree& tree, const Instance& instance, PartDraft& part, LevelDraft& level) {
  Collision collision = collisionOf(instance);
  if (collision.kind == CollisionKind::Hulls) {
    for (auto& hull : collision.hulls)
      if (hull.size() >= kLeastCorners && hull.size() <= kMostCorners &&
          std::all_of(hull.begin(), hull.end(), isFinite))
        part.hulls.push_back(std::move(hull));
    if (!part.hulls.empty()) return;
  }
  part.shape = Shape::block;
  if (collision.kind == CollisionKind::Box) return;
  part.evidence.push_back({"shape", "bounding box: " + collision.detail, true});
  if (part.solid)
    level.noteUnmodelled("shape of a mesh or union", tree.path(part.id),
                         "no collision hulls that can be read; its bounding box is taken");
}

}  // namespace

std::optional<PartDraft> partFrom(const Tree& tree, InstanceId id, LevelDraft& level) {
  const Instance& instance = tree.at(id);
  PartDraft part;
  part.id = id;
  part.shape = shapeOf(instance);
  part.size = abs(get<Vec3>(instance, "Size"));
  const auto frame = get<CFrame>(instance, "CFrame");
  if (!isFinite(frame.position) || !isFinite(part.size)) {
    level.noteUnmodelled("part without a place", tree.path(id),
                         "its position or size is not finite; left out");
    return std::nullopt;
  }
  bool reflected = false;
  part.pose = {frame.position, repairedRotation(frame.rotation, &reflected)};
  if (reflected)
    level.noteUnmodelled("mirrored part", tree.path(id),
                         "its rotation is a reflection; taken as the rotation with the same look "
                         "and up directions");
  part.anchored = get<bool>(instance, "Anchored");
  part.solid = get<bool>(instance, "CanCollide");
  part.touch = get<bool>(instance, "CanTouch");
  setSurface(instance, part);
  if (part.shape == Shape::hull) setHulls(tree, instance, part, level);
  return part;
}

}  // namespace obby::importer
