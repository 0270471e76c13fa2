// Decodes attributes: a u32 count, then name, kind and value of each attribute; little-endian, not
// interleaved.
#include "import/format/attributes.h"

#include <array>
#include <cstdio>
#include <unordered_set>

#include "engine/values/brick_colors.h"
#include "engine/values/color.h"
#include "import/format/byte_reader.h"
#include "import/format/rotation.h"

namespace obby::importer {
namespace {

// Max attributes of one instance. In memory, an entry takes some twenty times its bytes in the
// blob.
constexpr size_t kMaxAttributes = 1000;

Vec3 readVec3(ByteReader& reader) {
  const float x = reader.f32(), y = reader.f32(), z = reader.f32();
  return {x, y, z};
}

Value readColor(ByteReader& reader) {
  const Vec3 rgb = readVec3(reader);
  return colorFromUnit(rgb.x, rgb.y, rgb.z);
}

Value readCFrame(ByteReader& reader) {
  CFrame frame;
  frame.position = readVec3(reader);
  const uint8_t id = reader.u8();
  if (id != 0) {
    const auto rotation = rotationFromId(id);
    if (!rotation) reader.fail();
    frame.rotation = rotation.value_or(Mat3{});
    return frame;
  }
  std::array<float, 9> rows{};
  for (float& r : rows) r = reader.f32();
  frame.rotation = rotationFromRows(rows);
  return frame;
}

Value readUDim(ByteReader& reader) {
  const float scale = reader.f32();
  return UDim{scale, reader.i32()};
}

Value readEnumItem(ByteReader& reader) {
  std::string type(reader.string());
  return EnumItem{reader.u32(), std::move(type)};
}

// Skips a value of fixed or counted size that no level needs.
Value skip(ByteReader& reader, size_t size) {
  reader.bytes(size);
  return std::monostate{};
}
Value skipKeypoints(ByteReader& reader, size_t floats) {
  const uint32_t count = reader.u32();
  if (reader.has(count, floats * 4)) reader.bytes(count * floats * 4);
  return std::monostate{};
}
Value skipFont(ByteReader& reader) {
  reader.bytes(3);  // weight, style
  reader.string();  // family
  reader.string();  // cached face
  return std::monostate{};
}

struct AttributeKind {
  uint8_t id;
  Value (*read)(ByteReader&);
};

constexpr AttributeKind kAttributeKinds[] = {
    {0x02, [](ByteReader& r) -> Value { return std::string(r.string()); }},
    {0x03, [](ByteReader& r) -> Value { return r.u8() != 0; }},
    {0x04, [](ByteReader& r) -> Value { return int64_t{r.i32()}; }},
    {0x05, [](ByteReader& r) -> Value { return static_cast<double>(r.f32()); }},
    {0x06, [](ByteReader& r) -> Value { return r.f64(); }},
    {0x09, readUDim},
    {0x0a, [](ByteReader& r) { return skip(r, 16); }},  // UDim2
    {0x0e, [](ByteReader& r) -> Value { return brickColor(r.u32()); }},
    {0x0f, readColor},
    {0x10, [](ByteReader& r) { return skip(r, 8); }},  // Vector2
    {0x11, [](ByteReader& r) -> Value { return readVec3(r); }},
    {0x14, readCFrame},
    {0x15, readEnumItem},
    {0x17, [](ByteReader& r) { return skipKeypoints(r, 3); }},  // NumberSequence
    {0x19, [](ByteReader& r) { return skipKeypoints(r, 5); }},  // ColorSequence
    {0x1b, [](ByteReader& r) { return skip(r, 8); }},           // NumberRange
    {0x1c, [](ByteReader& r) { return skip(r, 16); }},          // Rect
    {0x21, skipFont},
};

const AttributeKind* findKind(uint8_t id) {
  for (const AttributeKind& kind : kAttributeKinds) {
    if (kind.id == id) return &kind;
  }
  return nullptr;
}

// Returns the attribute's name for a message, shortened: a file may have names of any length.
std::string quoted(const std::string& key) {
  constexpr size_t kShown = 100;  // bytes
  return key.size() <= kShown ? "'" + key + "'" : "'" + key.substr(0, kShown) + "...'";
}

std::string unknownKind(const std::string& key, uint8_t id) {
  char hex[8];
  std::snprintf(hex, sizeof hex, "0x%02x", id);
  return "attribute " + quoted(key) + " has the unknown type " + hex +
         "; it and the attributes after it are lost";
}

}  // namespace

DecodedAttributes decodeAttributes(std::string_view blob) {
  DecodedAttributes out;
  if (blob.empty()) return out;
  ByteReader reader(blob);
  const uint32_t count = reader.u32();
  for (uint32_t i = 0; i < count && reader.ok(); ++i) {
    std::string key(reader.string());
    const uint8_t id = reader.u8();
    if (!reader.ok()) break;
    const AttributeKind* kind = findKind(id);
    if (kind == nullptr) {
      out.warning = unknownKind(key, id);
      return out;
    }
    Value value = kind->read(reader);
    if (!reader.ok()) break;
    if (out.values.size() >= kMaxAttributes && !out.values.contains(key)) {
      out.warning = "it has more than " + std::to_string(kMaxAttributes) + " attributes; " +
                    quoted(key) + " and the attributes after it are lost";
      return out;
    }
    out.values[std::move(key)] = std::move(value);
  }
  if (!reader.ok()) out.warning = "the attributes end early; the last ones are lost";
  return out;
}

std::vector<std::string> decodeTags(std::string_view blob) {
  std::vector<std::string> tags;
  std::unordered_set<std::string_view> known;
  while (!blob.empty()) {
    const size_t end = blob.find('\0');
    const std::string_view tag = blob.substr(0, end);
    if (!tag.empty() && known.insert(tag).second) tags.emplace_back(tag);
    if (end == std::string_view::npos) break;
    blob.remove_prefix(end + 1);
  }
  return tags;
}

}  // namespace obby::importer
