// Turns the properties of a part into its collision shape and surface.
#include "import/parts/parts.h"

#include <algorithm>
#include <cmath>

#include "engine/classes/class_defaults.h"
#include "engine/values/materials.h"
#include "import/document/pose_math.h"

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
// Shapes by the value of the PartType enum.
constexpr Shape kPartTypes[] = {Shape::ball, Shape::block, Shape::cylinder, Shape::wedge,
                                Shape::cornerWedge};

Shape shapeOf(const Instance& instance) {
  for (const auto& row : kClassShapes)
    if (isA(instance.className, row.className)) return row.shape;
  if (!isA(instance.className, "Part")) return Shape::block;
  const uint32_t type = get<EnumItem>(instance, "Shape").value;
  return type < std::size(kPartTypes) ? kPartTypes[type] : Shape::block;
}

// Clamps a number of a file. NaN becomes the fallback.
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
  part.frictionWeight = within(physical.frictionWeight, 0, 100, part.frictionWeight);
  part.elasticity = within(physical.elasticity, 0, 1, part.elasticity);
  part.color = get<ColorRgb>(instance, "Color");
  part.transparency = within(get<double>(instance, "Transparency"), 0, 1, 0);
}

}  // namespace

std::optional<PartDraft> partFrom(const Tree& tree, InstanceId id, LevelHulls& hulls,
                                  LevelDraft& level) {
  const Instance& instance = tree.at(id);
  PartDraft part;
  part.id = id;
  part.shape = shapeOf(instance);
  part.size = abs(get<Vec3>(instance, "Size"));
  const auto frame = get<CFrame>(instance, "CFrame");
  if (!isFinite(frame.position) || !isFinite(part.size)) {
    level.noteUnmodelled("part with an invalid position or size", tree, id,
                         "its position or size is not finite; left out");
    return std::nullopt;
  }
  bool reflected = false;
  part.pose = {frame.position, repairedRotation(frame.rotation, &reflected)};
  if (reflected)
    level.noteUnmodelled("mirrored part", tree, id,
                         "its rotation is a reflection; replaced by the rotation with the same "
                         "look and up directions");
  part.anchored = get<bool>(instance, "Anchored");
  part.solid = get<bool>(instance, "CanCollide");
  part.touch = get<bool>(instance, "CanTouch");
  setSurface(instance, part);
  if (part.shape == Shape::hull) hulls.give(tree, part, level);
  return part;
}

}  // namespace obby::importer
