// One function for each kind of property, and the table of the kinds' numbers.
#include "support/place_columns.h"

#include <array>
#include <bit>
#include <stdexcept>

#include "import/format/rotation.h"

namespace obby::test {

using namespace importer;

namespace {

using Values = std::vector<FileValue>;

// Writes the most significant bytes of all values first, then the next bytes, and so on.
template <class Unsigned>
void interleave(std::string& out, const std::vector<Unsigned>& values) {
  for (int shift = static_cast<int>(sizeof(Unsigned)) * 8 - 8; shift >= 0; shift -= 8) {
    for (const Unsigned v : values) out += static_cast<char>((v >> shift) & 0xff);
  }
}

uint32_t zigzag(int32_t v) {
  return (static_cast<uint32_t>(v) << 1) ^ static_cast<uint32_t>(v >> 31);
}
uint64_t zigzag64(int64_t v) {
  return (static_cast<uint64_t>(v) << 1) ^ static_cast<uint64_t>(v >> 63);
}
uint32_t rotated(float v) {
  const auto bits = std::bit_cast<uint32_t>(v);
  return (bits << 1) | (bits >> 31);
}

template <class Unsigned, class Get>
void column(std::string& out, const Values& values, Get get) {
  std::vector<Unsigned> numbers;
  for (const FileValue& v : values) numbers.push_back(get(v.value));
  interleave(out, numbers);
}
template <class Get>
void floatColumn(std::string& out, const Values& values, Get get) {
  column<uint32_t>(out, values, [&](const Value& v) { return rotated(get(v)); });
}

const std::string& textIn(const Value& v) { return std::get<std::string>(v); }

void stringColumn(std::string& out, const Values& values) {
  for (const FileValue& v : values) appendString(out, textIn(v.value));
}
void boolColumn(std::string& out, const Values& values) {
  for (const FileValue& v : values) out += static_cast<char>(std::get<bool>(v.value));
}
void int32Column(std::string& out, const Values& values) {
  column<uint32_t>(out, values, [](const Value& v) {
    return zigzag(static_cast<int32_t>(std::get<int64_t>(v)));
  });
}
void int64Column(std::string& out, const Values& values) {
  column<uint64_t>(out, values, [](const Value& v) { return zigzag64(std::get<int64_t>(v)); });
}
void float32Column(std::string& out, const Values& values) {
  floatColumn(out, values, [](const Value& v) { return static_cast<float>(std::get<double>(v)); });
}
void float64Column(std::string& out, const Values& values) {
  for (const FileValue& v : values) appendDouble(out, std::get<double>(v.value));
}
void udimColumn(std::string& out, const Values& values) {
  floatColumn(out, values, [](const Value& v) { return std::get<UDim>(v).scale; });
  column<uint32_t>(out, values, [](const Value& v) { return zigzag(std::get<UDim>(v).offset); });
}
void rangeColumn(std::string& out, const Values& values) {
  for (const FileValue& v : values) {
    appendFloat(out, std::get<NumberRange>(v.value).min);
    appendFloat(out, std::get<NumberRange>(v.value).max);
  }
}
void brickColumn(std::string& out, const Values& values) {
  column<uint32_t>(out, values,
                   [](const Value& v) { return static_cast<uint32_t>(std::get<int64_t>(v)); });
}
void enumColumn(std::string& out, const Values& values) {
  column<uint32_t>(out, values, [](const Value& v) { return std::get<EnumItem>(v).value; });
}
void refColumn(std::string& out, const Values& values) {
  std::vector<int32_t> targets;
  for (const FileValue& v : values) {
    targets.push_back(static_cast<int32_t>(std::get<Ref>(v.value).target));  // none is -1
  }
  appendReferents(out, targets);
}

uint8_t colorPart(const Value& v, int i) {
  const auto c = std::get<ColorRgb>(v);
  return i == 0 ? c.r : i == 1 ? c.g : c.b;
}
void colorColumn(std::string& out, const Values& values) {
  for (const int i : {0, 1, 2}) {
    floatColumn(out, values,
                [&](const Value& v) { return static_cast<float>(colorPart(v, i)) / 255; });
  }
}
void byteColorColumn(std::string& out, const Values& values) {
  for (const int i : {0, 1, 2}) {
    for (const FileValue& v : values) out += static_cast<char>(colorPart(v.value, i));
  }
}

void vectorColumns(std::string& out, const std::vector<Vec3>& vectors) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<uint32_t> bits;
    for (const Vec3 v : vectors) bits.push_back(rotated(component(v, axis)));
    interleave(out, bits);
  }
}

void vectorColumn(std::string& out, const Values& values) {
  std::vector<Vec3> vectors;
  for (const FileValue& v : values) vectors.push_back(std::get<Vec3>(v.value));
  vectorColumns(out, vectors);
}

void cframeColumns(std::string& out, const Values& values) {
  std::vector<Vec3> positions;
  for (const FileValue& v : values) {
    const CFrame frame = v.value.index() == 0 ? CFrame{} : std::get<CFrame>(v.value);
    appendRotation(out, frame.rotation);
    positions.push_back(frame.position);
  }
  vectorColumns(out, positions);
}

void optionalCFrames(std::string& out, const Values& values) {
  out += '\x10';
  cframeColumns(out, values);
  out += '\x02';
  for (const FileValue& v : values) out += static_cast<char>(v.value.index() != 0);
}

void physicalColumn(std::string& out, const Values& values) {
  for (const FileValue& v : values) {
    const auto& p = std::get<PhysicalProperties>(v.value);
    out += static_cast<char>((p.custom ? 1 : 0) | (v.acoustics ? 2 : 0));
    if (!p.custom) continue;
    for (const float f :
         {p.density, p.friction, p.elasticity, p.frictionWeight, p.elasticityWeight}) {
      appendFloat(out, f);
    }
    if (v.acoustics) appendFloat(out, 0.25f);
  }
}

void uniqueIds(std::string& out, const Values& values) {
  std::vector<std::array<uint8_t, 16>> ids;
  for (const FileValue& v : values) {
    const auto number = [&](size_t at, size_t digits) {
      return std::stoull(textIn(v.value).substr(at, digits), nullptr, 16);
    };
    uint64_t random = number(0, 16);
    random = (random << 1) | (random >> 63);
    const uint64_t head = (number(24, 8) << 32) | number(16, 8);  // index, time
    std::array<uint8_t, 16>& id = ids.emplace_back();
    for (size_t i = 0; i < 8; ++i) {
      id[i] = static_cast<uint8_t>(head >> (56 - 8 * i));
      id[8 + i] = static_cast<uint8_t>(random >> (56 - 8 * i));
    }
  }
  for (size_t byte = 0; byte < 16; ++byte) {
    for (const auto& id : ids) out += static_cast<char>(id[byte]);
  }
}

void contents(std::string& out, const Values& values) {
  std::vector<uint32_t> sources;
  std::string uris;
  uint32_t count = 0;
  for (const FileValue& v : values) {
    const bool none = textIn(v.value).empty();
    sources.push_back(none ? 0 : 1);
    if (none) continue;
    appendString(uris, textIn(v.value));
    ++count;
  }
  interleave(out, sources);
  append(out, count);
  out += uris;
  append(out, 0);
  append(out, 0);
}

// Returns sample bytes. Kinds that a Document does not keep can have any bytes of the right length.
std::string sampleBytes(FileKind kind) {
  std::string out;
  switch (kind) {
    case FileKind::UDim2:
    case FileKind::Rect: return std::string(16, '\x11');
    case FileKind::Ray: return std::string(24, '\x12');
    case FileKind::Faces:
    case FileKind::Axes: return std::string(1, '\x05');
    case FileKind::Vector2: return std::string(8, '\x13');
    case FileKind::Vector3int16: return std::string(6, '\x14');
    case FileKind::NumberSequence: append(out, 2); return out + std::string(2 * 12, '\x15');
    case FileKind::ColorSequence: append(out, 3); return out + std::string(3 * 20, '\x16');
    case FileKind::Font:
      appendString(out, "rbxasset://fonts/families/Arial.json");
      out += std::string("\xbc\x02\x01", 3);
      appendString(out, "");
      return out;
    default: throw std::logic_error("no sample of this kind");
  }
}

struct ColumnKind {
  FileKind kind;
  void (*write)(std::string&, const Values&);
};

constexpr ColumnKind kKinds[] = {
    {FileKind::String, stringColumn},
    {FileKind::Bool, boolColumn},
    {FileKind::Int32, int32Column},
    {FileKind::Float32, float32Column},
    {FileKind::Float64, float64Column},
    {FileKind::UDim, udimColumn},
    {FileKind::NumberRange, rangeColumn},
    {FileKind::BrickColor, brickColumn},
    {FileKind::Color3, colorColumn},
    {FileKind::Vector3, vectorColumn},
    {FileKind::CFrame, cframeColumns},
    {FileKind::Enum, enumColumn},
    {FileKind::Ref, refColumn},
    {FileKind::PhysicalProperties, physicalColumn},
    {FileKind::Color3uint8, byteColorColumn},
    {FileKind::Int64, int64Column},
    {FileKind::Bytecode, stringColumn},
    {FileKind::OptionalCFrame, optionalCFrames},
    {FileKind::UniqueId, uniqueIds},
    {FileKind::SecurityCapabilities, int64Column},
    {FileKind::Content, contents},
};

uint32_t sharedIndex(SharedStrings& strings, const std::string& bytes) {
  for (size_t i = 0; i < strings.size(); ++i) {
    if (strings[i] == bytes) return static_cast<uint32_t>(i);
  }
  strings.push_back(bytes);
  return static_cast<uint32_t>(strings.size() - 1);
}

}  // namespace

std::string columnOf(FileKind kind, const std::vector<FileValue>& values, SharedStrings& strings) {
  std::string out;
  if (kind == FileKind::SharedString) {
    column<uint32_t>(out, values, [&](const Value& v) {
      return sharedIndex(strings, *std::get<SharedBlob>(v).bytes);
    });
    return out;
  }
  for (const ColumnKind& row : kKinds) {
    if (row.kind != kind) continue;
    row.write(out, values);
    return out;
  }
  for (size_t i = 0; i < values.size(); ++i) out += sampleBytes(kind);
  return out;
}

void append(std::string& out, uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((value >> shift) & 0xff);
}
void appendFloat(std::string& out, float value) { append(out, std::bit_cast<uint32_t>(value)); }
void appendDouble(std::string& out, double value) {
  const auto bits = std::bit_cast<uint64_t>(value);
  append(out, static_cast<uint32_t>(bits));
  append(out, static_cast<uint32_t>(bits >> 32));
}
void appendString(std::string& out, const std::string& value) {
  append(out, static_cast<uint32_t>(value.size()));
  out += value;
}

void appendRotation(std::string& out, const Mat3& rotation) {
  for (uint8_t id = 1; id <= 36; ++id) {
    const auto axes = rotationFromId(id);
    if (axes && axes->x == rotation.x && axes->y == rotation.y && axes->z == rotation.z) {
      out += static_cast<char>(id);
      return;
    }
  }
  out += '\0';
  for (int row = 0; row < 3; ++row) {
    for (const Vec3 axis : {rotation.x, rotation.y, rotation.z})
      appendFloat(out, component(axis, row));
  }
}

void appendReferents(std::string& out, const std::vector<int32_t>& referents) {
  std::vector<uint32_t> steps;
  int32_t last = 0;
  for (const int32_t r : referents) {
    steps.push_back(zigzag(r - last));
    last = r;
  }
  interleave(out, steps);
}

}  // namespace obby::test
