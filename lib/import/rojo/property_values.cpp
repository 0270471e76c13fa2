#include "import/rojo/property_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/classes/class_defaults.h"
#include "engine/values/materials.h"
#include "import/format/property_names.h"
#include "io/base64.h"

namespace obby::importer::rojo {
namespace {

// Items of enums that a level depends on, by property. Material has a table of its own.
struct Item {
  std::string_view property, name;
  uint32_t value;
};
constexpr Item kItems[] = {{"Shape", "Ball", 0},
                           {"Shape", "Block", 1},
                           {"Shape", "Cylinder", 2},
                           {"Shape", "Wedge", 3},
                           {"Shape", "CornerWedge", 4},
                           {"ActuatorType", "None", 0},
                           {"ActuatorType", "Motor", 1},
                           {"ActuatorType", "Servo", 2},
                           {"AngularActuatorType", "None", 0},
                           {"AngularActuatorType", "Motor", 1},
                           {"AngularActuatorType", "Servo", 2},
                           {"RunContext", "Legacy", 0},
                           {"RunContext", "Server", 1},
                           {"RunContext", "Client", 2},
                           {"RunContext", "Plugin", 3},
                           {"RigType", "R6", 0},
                           {"RigType", "R15", 1},
                           {"GameSettingsAvatar", "R6", 0},
                           {"GameSettingsAvatar", "R15", 1},
                           {"GameSettingsAvatar", "PlayerChoice", 2},
                           {"AuthorityMode", "Server", 0},
                           {"AuthorityMode", "Automatic", 1}};

std::optional<Value> itemOf(std::string_view property, std::string_view name) {
  if (property == "Material") {
    if (const auto material = materialNamed(name)) return EnumItem{*material, {}};
    return {};
  }
  for (const Item& item : kItems)
    if (item.property == property && item.name == name) return EnumItem{item.value, {}};
  return {};
}

Vec3 vectorOf(const std::vector<double>& n, size_t at = 0) {
  return {float(n[at]), float(n[at + 1]), float(n[at + 2])};
}

uint8_t channelOf(double value) {
  return uint8_t(std::clamp(std::isnan(value) ? 0.0 : std::round(value), 0.0, 255.0));
}

ColorRgb colorOf(const std::vector<double>& n, double scale) {
  return {channelOf(n[0] * scale), channelOf(n[1] * scale), channelOf(n[2] * scale)};
}

// Reads the position, then the rows of the rotation.
CFrame frameOf(const std::vector<double>& n) {
  CFrame frame;
  frame.position = vectorOf(n);
  const Vec3 a = vectorOf(n, 3), b = vectorOf(n, 6), c = vectorOf(n, 9);
  frame.rotation = {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
  return frame;
}

std::optional<Value> explicitFrame(const Json& json) {
  auto numbers = json["position"].numbers();
  if (!numbers || numbers->size() != 3) return {};
  const Json rows = json["orientation"];
  if (!rows.isArray()) return {};
  for (const auto& [name, row] : rows.members()) {
    const auto three = row.numbers();
    if (!three || three->size() != 3) return {};
    numbers->insert(numbers->end(), three->begin(), three->end());
  }
  if (numbers->size() != 12) return {};
  return frameOf(*numbers);
}

std::optional<Value> physicalOf(const Json& json) {
  if (json.isText()) return PhysicalProperties{};
  if (!json.isObject()) return {};
  const auto number = [&](const char* name, float fallback) {
    return float(json[name].number().value_or(fallback));
  };
  return PhysicalProperties{true,
                            number("density", 0.7f),
                            number("friction", 0.3f),
                            number("elasticity", 0.5f),
                            number("frictionWeight", 1),
                            number("elasticityWeight", 1)};
}

std::optional<Value> listOf(std::string_view type, const std::vector<double>& n) {
  if (n.size() == 3 && (type == "Vector3" || type == "Vector3int16")) return vectorOf(n);
  if (n.size() == 3 && type == "Color3") return colorOf(n, 255);
  if (n.size() == 3 && type == "Color3uint8") return colorOf(n, 1);
  if (n.size() == 12 && type == "CFrame") return frameOf(n);
  if (n.size() == 2 && type == "NumberRange") return NumberRange{float(n[0]), float(n[1])};
  return {};
}

std::optional<Value> numberOf(std::string_view type, double n) {
  if (type == "Float32" || type == "Float64") return n;
  const bool isWhole = std::fabs(n) < 9e15;
  if (!isWhole) return {};
  if (type == "Int32" || type == "Int64" || type == "BrickColor") return int64_t(n);
  if (type == "Enum" && n >= 0 && n <= 0x7fffffff) return EnumItem{uint32_t(n), {}};
  return {};
}

std::optional<Value> textOf(std::string_view type, const std::string& text) {
  if (type == "String" || type == "Content" || type == "ContentId") return text;
  if (type != "BinaryString" && type != "SharedString") return {};
  auto bytes = io::decodeBase64(text);
  if (!bytes) return {};
  return *std::move(bytes);
}

// Reads {"Type": value}.
std::optional<Value> explicitValue(const Json& json) {
  if (json.size() != 1) return {};
  const auto members = json.members();
  const std::string_view type = members[0].first;
  const Json value = members[0].second;
  if (type == "Bool" && value.flag()) return *value.flag();
  if (type == "CFrame" && value.isObject()) return explicitFrame(value);
  if (type == "OptionalCFrame" && value.isObject()) return explicitFrame(value);
  if (type == "PhysicalProperties") return physicalOf(value);
  if (const auto numbers = value.numbers()) return listOf(type, *numbers);
  if (const auto number = value.number()) return numberOf(type, *number);
  if (const auto text = value.text()) return textOf(type, *text);
  return {};
}

// Returns the name of the type that a plain list has.
std::string_view typeLike(const Value* standard, size_t count) {
  if (standard && std::holds_alternative<ColorRgb>(*standard)) return "Color3";
  if (standard && std::holds_alternative<NumberRange>(*standard)) return "NumberRange";
  return count == 12 ? "CFrame" : count == 3 ? "Vector3" : "";
}

}  // namespace

std::optional<Value> propertyValue(std::string_view className, std::string_view property,
                                   const Json& json) {
  if (json.isObject()) return explicitValue(json);
  const PropertySpelling spelling = spellingOf(className, property);
  const Value* standard = defaultOf(className, spelling.name);
  if (const auto flag = json.flag()) return *flag;
  if (const auto number = json.number()) return *number;
  if (const auto numbers = json.numbers())
    return listOf(typeLike(standard, numbers->size()), *numbers);
  const auto text = json.text();
  if (!text) return {};
  if (const auto item = itemOf(spelling.name, *text)) return item;
  if (standard && std::holds_alternative<EnumItem>(*standard)) return {};
  return *text;
}

std::optional<Value> attributeValue(const Json& json) {
  if (json.isObject()) return explicitValue(json);
  if (const auto flag = json.flag()) return *flag;
  if (const auto number = json.number()) return *number;
  if (const auto text = json.text()) return *text;
  return {};
}

}  // namespace obby::importer::rojo
