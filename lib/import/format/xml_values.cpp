// Reads each kind of property with one function, by a table of element names.
#include "import/format/xml_values.h"

#include <algorithm>
#include <array>

#include "engine/values/color.h"
#include "import/format/rotation.h"
#include "import/format/xml_numbers.h"
#include "io/base64.h"

namespace obby::importer {
namespace {

using Element = pugi::xml_node;
using ReadElement = Result<Value> (*)(Element, const XmlContext&);

Error expected(std::string_view what, std::string_view got, std::string path = {}) {
  constexpr size_t kShown = 30;
  std::string shown(got.substr(0, kShown));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return Error{
      {}, {}, std::move(path), "expected " + std::string(what) + ", found '" + shown + "'", {}};
}

std::string_view viewOf(Element element) { return element.child_value(); }

Result<Value> readText(Element element, const XmlContext&) { return Value{textOf(element)}; }

Result<Value> readBase64(Element element, const XmlContext&) {
  const std::string text = textOf(element);
  auto bytes = io::decodeBase64(text);
  if (!bytes) return expected("base64", text);
  return Value{std::move(*bytes)};
}

Result<Value> readShared(Element element, const XmlContext& context) {
  const auto it = context.sharedStrings.find(viewOf(element));
  if (it == context.sharedStrings.end()) {
    return expected("the key of a shared string", viewOf(element));
  }
  return Value{SharedBlob{it->second}};
}

Result<Value> readBool(Element element, const XmlContext&) {
  if (const auto value = parseBool(viewOf(element))) return Value{*value};
  return expected("true or false", viewOf(element));
}
Result<Value> readInt(Element element, const XmlContext&) {
  if (const auto value = parseInt(viewOf(element))) return Value{*value};
  return expected("a whole number", viewOf(element));
}
Result<Value> readSingle(Element element, const XmlContext&) {
  if (const auto value = parseFloat(viewOf(element))) return Value{static_cast<double>(*value)};
  return expected("a number", viewOf(element));
}
Result<Value> readDouble(Element element, const XmlContext&) {
  if (const auto value = parseDouble(viewOf(element))) return Value{*value};
  return expected("a number", viewOf(element));
}
Result<Value> readToken(Element element, const XmlContext&) {
  if (const auto value = parseInt(viewOf(element))) {
    return Value{EnumItem{static_cast<uint32_t>(*value), {}}};
  }
  return expected("the number of an enum item", viewOf(element));
}

// Returns the numbers in the children of the given names.
template <size_t Count>
Result<std::array<float, Count>> readParts(Element element,
                                           const std::array<const char*, Count>& names) {
  std::array<float, Count> out{};
  for (size_t i = 0; i < Count; ++i) {
    const std::string_view text = viewOf(element.child(names[i]));
    const auto value = parseFloat(text);
    if (!value) return expected("a number", text, names[i]);
    out[i] = *value;
  }
  return out;
}

Result<Value> readVec3(Element element, const XmlContext&) {
  OBBY_ASSIGN(const auto v, readParts<3>(element, {"X", "Y", "Z"}));
  return Value{Vec3{v[0], v[1], v[2]}};
}

Result<Value> readCFrame(Element element, const XmlContext&) {
  OBBY_ASSIGN(const auto v, readParts<12>(element, {"X", "Y", "Z", "R00", "R01", "R02", "R10",
                                                    "R11", "R12", "R20", "R21", "R22"}));
  return Value{CFrame{{v[0], v[1], v[2]},
                      rotationFromRows({v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10], v[11]})}};
}

Result<Value> readOptionalCFrame(Element element, const XmlContext& context) {
  const Element frame = element.child("CFrame");
  return frame ? readCFrame(frame, context) : Result<Value>(Value{});
}

// Reads three numbers from 0 to 1, or one packed number. Elements of either name hold either form.
Result<Value> readColor(Element element, const XmlContext&) {
  if (element.child("R")) {
    OBBY_ASSIGN(const auto v, readParts<3>(element, {"R", "G", "B"}));
    return Value{colorFromUnit(v[0], v[1], v[2])};
  }
  if (const auto packed = parseInt(viewOf(element))) {
    return Value{colorFromPacked(static_cast<uint32_t>(*packed))};
  }
  return expected("a colour", viewOf(element));
}

Result<Value> readRef(Element element, const XmlContext& context) {
  const auto it = context.instances.find(viewOf(element));
  return Value{Ref{it == context.instances.end() ? kNoInstance : it->second}};
}

Result<Value> readPhysical(Element element, const XmlContext&) {
  PhysicalProperties p;
  const std::string_view text = viewOf(element.child("CustomPhysics"));
  const auto custom = parseBool(text);
  if (!custom) return expected("true or false", text, "CustomPhysics");
  p.custom = *custom;
  if (!p.custom) return Value{p};
  OBBY_ASSIGN(const auto v, readParts<5>(element, {"Density", "Friction", "Elasticity",
                                                   "FrictionWeight", "ElasticityWeight"}));
  return Value{PhysicalProperties{true, v[0], v[1], v[2], v[3], v[4]}};
}

Result<Value> readUniqueId(Element element, const XmlContext&) {
  std::string text = textOf(element);
  for (char& c : text) {
    if (c >= 'A' && c <= 'F') c = static_cast<char>(c | 0x20);
  }
  return Value{std::move(text)};
}

Result<Value> readContent(Element element, const XmlContext& context) {
  if (const Element ref = element.child("Ref")) return readRef(ref, context);
  for (const char* name : {"url", "uri"}) {
    if (const Element address = element.child(name)) return Value{textOf(address)};
  }
  return Value{textOf(element)};
}

Result<Value> readUDim(Element element, const XmlContext&) {
  OBBY_ASSIGN(const auto v, readParts<1>(element, {"S"}));
  const std::string_view text = viewOf(element.child("O"));
  const auto offset = parseInt(text);
  if (!offset) return expected("a whole number", text, "O");
  return Value{UDim{v[0], static_cast<int32_t>(*offset)}};
}

// Reads "0.9 1.05 ". A malformed range is no error, since most ranges belong to visual effects.
Result<Value> readRange(Element element, const XmlContext&) {
  const std::string_view text = viewOf(element);
  const size_t space = std::min(text.find(' '), text.size());
  const std::string_view rest = text.substr(std::min(space + 1, text.size()));
  const auto min = parseFloat(text.substr(0, space));
  const auto max = parseFloat(rest.substr(0, rest.find(' ')));
  if (!min || !max) return Value{};
  return Value{NumberRange{*min, *max}};
}

Result<Value> ignoreElement(Element, const XmlContext&) { return Value{}; }

struct XmlKind {
  std::string_view element;
  ReadElement read;
};

constexpr XmlKind kXmlKinds[] = {
    {"Axes", ignoreElement},
    {"BinaryString", readBase64},
    {"BrickColor", readInt},
    {"CFrame", readCFrame},
    {"Color3", readColor},
    {"Color3uint8", readColor},
    {"ColorSequence", ignoreElement},
    {"Content", readContent},
    {"ContentId", readContent},
    {"CoordinateFrame", readCFrame},
    {"Faces", ignoreElement},
    {"Font", ignoreElement},
    {"NetAssetRef", readShared},
    {"NumberRange", readRange},
    {"NumberSequence", ignoreElement},
    {"OptionalCoordinateFrame", readOptionalCFrame},
    {"PhysicalProperties", readPhysical},
    {"ProtectedString", readText},
    {"Ray", ignoreElement},
    {"Rect2D", ignoreElement},
    {"Ref", readRef},
    {"SecurityCapabilities", readInt},
    {"SharedString", readShared},
    {"UDim", readUDim},
    {"UDim2", ignoreElement},
    {"UniqueId", readUniqueId},
    {"Vector2", ignoreElement},
    {"Vector2int16", ignoreElement},
    {"Vector3", readVec3},
    {"Vector3int16", ignoreElement},
    {"bool", readBool},
    {"double", readDouble},
    {"float", readSingle},
    {"int", readInt},
    {"int64", readInt},
    {"string", readText},
    {"token", readToken},
};

ReadElement byElementName(std::string_view name) {
  for (const XmlKind& kind : kXmlKinds) {
    if (kind.element == name) return kind.read;
  }
  return nullptr;
}

// Returns the reader for a property whose kind is known, or null if the element's name must decide.
ReadElement byStandard(const Value& standard, std::string_view elementName) {
  if (std::holds_alternative<bool>(standard)) return readBool;
  if (std::holds_alternative<int64_t>(standard)) return readInt;
  if (std::holds_alternative<EnumItem>(standard)) return readToken;
  if (std::holds_alternative<Vec3>(standard)) return readVec3;
  if (std::holds_alternative<CFrame>(standard)) return readCFrame;
  if (std::holds_alternative<ColorRgb>(standard)) return readColor;
  if (std::holds_alternative<Ref>(standard)) return readRef;
  if (std::holds_alternative<PhysicalProperties>(standard)) return readPhysical;
  if (std::holds_alternative<double>(standard) && elementName != "double") return readSingle;
  return nullptr;
}

// Chooses a reader by the children of an element with an unknown name.
ReadElement byStructure(Element element) {
  if (element.child("R00")) return readCFrame;
  if (element.child("X") && element.child("Z")) return readVec3;
  if (element.child("R") && element.child("G")) return readColor;
  return element.find_child([](Element child) { return child.type() == pugi::node_element; })
             ? ignoreElement
             : readText;
}

}  // namespace

std::string textOf(pugi::xml_node element) {
  std::string out;
  for (const Element child : element.children()) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) out += child.value();
  }
  return out;
}

Result<Value> readXmlValue(pugi::xml_node element, const Value* standard,
                           const XmlContext& context) {
  const std::string_view name = element.name();
  ReadElement read = standard != nullptr ? byStandard(*standard, name) : nullptr;
  // Generated files name this property a string, but it holds base64.
  const std::string_view property = element.attribute("name").value();
  if (property == "AttributesSerialize" && name == "string") read = readBase64;
  if (read == nullptr) read = byElementName(name);
  if (read == nullptr) read = byStructure(element);
  return read(element, context);
}

}  // namespace obby::importer
