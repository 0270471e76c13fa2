// A small place with one property of every kind in the formats.
#pragma once

#include "support/place_writer.h"

namespace obby::test {

inline CFrame tiltedFrame() {
  return {{1.5f, -2.25f, 1e-7f}, {{0.6f, 0.8f, 0}, {-0.8f, 0.6f, 0}, {0, 0, 1}}};
}

// Returns a place with Workspace, the part Lava, a Folder, the part Ice in it, and a script in
// Lava. The ids are in this order.
inline PlaceWriter samplePlace() {
  PlaceWriter place;
  const auto workspace = place.add("Workspace", "Workspace");
  const auto lava = place.add("Part", "Lava", workspace);
  const auto folder = place.add("Folder", "Folder <&> 'x'", workspace);
  const auto ice = place.add("Part", "Ice", folder);
  const auto script = place.add("Script", "KillScript", lava);
  place.set(workspace, "Gravity", float32(80)).set(workspace, "PrimaryPart", ref(ice));
  place.set(lava, "size", vec3(4, 1, 2))
      .set(lava, "CFrame", cframe(tiltedFrame()))
      .set(lava, "Anchored", flag(true))
      .set(lava, "Color3uint8", color8({255, 0, 10}))
      .set(lava, "shape", token(2))
      .set(lava, "CustomPhysicalProperties", physical({true, 1, 0.02f, 0.5f, 3, 1}, true))
      .set(lava, "PhysicalConfigData", shared(std::string("a\0b", 3)))
      .set(lava, "UniqueId", uniqueId("44b188dace632b4702e9c68d004815fc"));
  place.set(ice, "CFrame", cframe(7, 8, 9))
      .set(ice, "CustomPhysicalProperties", physical({}, true))
      .set(ice, "Anchored", flag(false))
      .set(ice, "Color3uint8", color8({0, 128, 255}))
      .set(ice, "shape", token(1))
      .set(ice, "PhysicalConfigData", shared(""))
      .set(ice, "size", vec3(1e30f, 0.001f, -0.0f))
      .set(ice, "UniqueId", uniqueId("ffffffffffffffff0000000100000002"));
  place.set(script, "Source", source("-- \"kill\" <&>\nlocal x = '&#0;'"));
  place.tag(lava, "KillBrick").tag(lava, "Checkpoint");
  place.attribute(lava, "Damage", 25.0)
      .attribute(lava, "Kind", EnumItem{3, "Material"})
      .attribute(lava, "Owner", std::string("me"));
  const auto kinds = place.add("Configuration", "Kinds", workspace);
  place.set(kinds, "A", int32(-123456))
      .set(kinds, "B", int64(-1234567890123456789))
      .set(kinds, "C", float64(0.1))
      .set(kinds, "D", udim(0.25f, -7))
      .set(kinds, "E", brickNumber(1004))
      .set(kinds, "F", color3({1, 2, 3}))
      .set(kinds, "G", optionalCFrame(tiltedFrame()))
      .set(kinds, "H", optionalCFrame({}))
      .set(kinds, "I", capabilities(768))
      .set(kinds, "J", content("rbxassetid://1"))
      .set(kinds, "K", content(""))
      .set(kinds, "L", address("rbxassetid://2"))
      .set(kinds, "M", blob("\x01\x02"))
      .set(kinds, "O", range(0.9f, 1.05f))
      .set(kinds, "N", ref(kNoInstance));
  char name = 'P';
  for (const FileKind kind : {FileKind::UDim2, FileKind::Ray, FileKind::Faces, FileKind::Axes,
                              FileKind::Vector2, FileKind::Vector3int16, FileKind::NumberSequence,
                              FileKind::ColorSequence, FileKind::Rect, FileKind::Font}) {
    place.set(kinds, std::string(1, name++), unread(kind));
  }
  return place;
}

}  // namespace obby::test
