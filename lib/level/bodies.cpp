#include "level/bodies.h"

#include <capnp/dynamic.h>

#include <algorithm>
#include <vector>

#include "base/listed.h"

namespace obby::level {

namespace {

constexpr BodyNumber kR6[] = {
    {"hipHeight", 2, "H leg length of the R6 rig"},
    {"rootHeight", 2, "H HumanoidRootPart.Size.Y"},
    {"bodyWidth", 2, "H Torso.Size.X"},
    {"bodyDepth", 1, "H Torso.Size.Z"},
    {"headBottom", 4, "H bottom of Head"},
    {"bodyTop", 5, "H top of Head"},
    {"armSpan", 4, "H torso and both arms"},
    {"traction", 2060, "measured: 618 on plastic"},
};

// The collision boxes are those of the classic R15 body, which InnerBox gives every avatar. Under
// OuterBox, the engine's default, they follow the meshes of the avatar.
constexpr BodyNumber kR15[] = {
    {"hipHeight", 2, "H the engine's canonical hip height; 1.35 in the editor's rig"},
    {"rootHeight", 2, "H HumanoidRootPart.Size.Y"},
    {"bodyWidth", 2, "H LowerTorso.Size.X"},
    {"bodyDepth", 1, "H LowerTorso.Size.Z"},
    {"headBottom", 4, "M top of UpperTorso: 0.4 + 1.6 above the hips"},
    {"bodyTop", 5, "H Head.Size.Y above it"},
    {"armSpan", 4, "L torso and both arms, each 1 wide"},
    {"traction", 2777, "measured: 833 on plastic; avatars of other mass have 763 to 3847"},
};

constexpr Body kBodies[] = {{"r6", "R6", kR6}, {"r15", "R15", kR15}};

}  // namespace

std::span<const Body> bodies() { return kBodies; }

const Body* findBody(std::string_view name) {
  const auto row = std::ranges::find_if(kBodies, [&](const Body& b) { return name == b.name; });
  return row == std::end(kBodies) ? nullptr : row;
}

std::string bodyNames() {
  std::vector<std::string> names;
  for (const Body& body : kBodies) names.emplace_back(body.name);
  return listed(names, "or");
}

void setBody(const Body& body, schema::PhysicsParams::Builder physics) {
  capnp::DynamicStruct::Builder fields(physics);
  for (const BodyNumber& n : body.numbers) fields.set(n.field, n.value);
}

}  // namespace obby::level
