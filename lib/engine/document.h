// A Roblox place or model file in memory: a tree of instances with properties, independent of the
// file format. Readers (binary, XML) fill it; the level builder reads it. Nothing here depends on
// the meaning of a property.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "engine/property_map.h"
#include "math/vec.h"

namespace obby {

// An index into Document::instances.
using InstanceId = uint32_t;
constexpr InstanceId kNoInstance = std::numeric_limits<InstanceId>::max();

// Rotation as three columns (a reflection in damaged files) and position.
using CFrame = Pose;

struct Ref {
  InstanceId target = kNoInstance;
};

struct ColorRgb {
  uint8_t r = 0, g = 0, b = 0;
};

// CustomPhysicalProperties; if `custom` is false, the material's are used.
struct PhysicalProperties {
  bool custom = false;
  float density = 0.7f, friction = 0.3f, elasticity = 0.5f, frictionWeight = 1,
        elasticityWeight = 1;
};

struct EnumItem {
  uint32_t value = 0;
  std::string type;  // the enum's name; only attributes have it
};

struct UDim {
  float scale = 0;
  int32_t offset = 0;
};

struct NumberRange {
  float min = 0, max = 0;
};

// Bytes that the file stores once and many instances share: meshes and collision data.
struct SharedBlob {
  std::shared_ptr<const std::string> bytes;  // never null
};

// The kinds that a level needs. A property of any other type is read exactly and kept as
// std::monostate, so that its presence still shows. Strings hold bytes of any kind
// (ProtectedString, BinaryString and asset addresses included). BrickColor numbers are int64_t
// except for a part's colour. UniqueIds are 32 hexadecimal digits.
using Value =
    std::variant<std::monostate, bool, int64_t, double, std::string, EnumItem, Vec3, CFrame,
                 ColorRgb, Ref, PhysicalProperties, UDim, SharedBlob, NumberRange>;

struct Instance {
  std::string className;
  std::string name;               // the Name property
  PropertyMap<Value> properties;  // no Name, Tags, attributes; named as in property_names.h
  std::map<std::string, Value> attributes;  // decoded AttributesSerialize
  std::vector<std::string> tags;            // decoded Tags, in file order
  InstanceId parent = kNoInstance;
  std::vector<InstanceId> children;  // in file order
};

struct Document {
  std::string file;    // file name as given
  std::string format;  // "rbxl", "rbxm" (binary), "rbxlx", "rbxmx" (XML), by content: a place has
                       // services as roots
  std::vector<Instance> instances;  // parents before children
  std::vector<InstanceId> roots;
  std::vector<std::string> warnings;  // data skipped while reading, for --verbose
};

// Typed access. Each returns null (or the fallback) if the property is absent or of another type.
template <class T>
const T* property(const Instance& instance, const std::string& name) {
  const auto it = instance.properties.find(name);
  return it == instance.properties.end() ? nullptr : std::get_if<T>(&it->second);
}
template <class T>
T propertyOr(const Instance& instance, const std::string& name, T fallback) {
  const T* value = property<T>(instance, name);
  return value ? *value : fallback;
}

}  // namespace obby
