// Reads each kind of property with one function; a table numbers the kinds. Kinds that no level
// needs are skipped and leave std::monostate.
#include "import/format/binary_values.h"

#include <fmt/format.h>

#include <array>
#include <bit>

#include "engine/values/color.h"
#include "import/format/columns.h"
#include "import/format/rotation.h"

namespace obby::importer {
namespace {

struct Column {
  size_t count;
  ByteReader& reader;
  const ColumnContext& context;
  std::vector<Value>& out;
  std::string problem = {};  // an error other than missing bytes

  // Reads consecutive values. `lowest` is the min size of one value in bytes.
  template <class Read>
  void each(size_t lowest, Read read) {
    if (!reader.has(count, lowest)) return;
    for (size_t i = 0; i < count && reader.ok() && problem.empty(); ++i) out.emplace_back(read());
  }
  template <class Number, class Convert>
  void convert(const std::vector<Number>& numbers, Convert toValue) {
    out.reserve(numbers.size());
    for (const Number& n : numbers) out.emplace_back(toValue(n));
  }
  void skipFixed(size_t size) {
    each(size, [&] {
      reader.bytes(size);
      return std::monostate{};
    });
  }
  void skipKeypoints(size_t floats) {
    each(4, [&] {
      const uint32_t keys = reader.u32();
      if (reader.has(keys, floats * 4)) reader.bytes(keys * floats * 4);
      return std::monostate{};
    });
  }
  void fail(std::string message) {
    problem = std::move(message);
    reader.fail();
  }
};

void readStrings(Column& c) {
  c.each(4, [&] { return std::string(c.reader.string()); });
}
void readBools(Column& c) {
  c.each(1, [&] { return c.reader.u8() != 0; });
}
void readInts(Column& c) {
  c.convert(readInt32Column(c.reader, c.count), [](int32_t v) { return int64_t{v}; });
}
void readInt64s(Column& c) {
  c.convert(readInt64Column(c.reader, c.count), [](int64_t v) { return v; });
}
void readFloats(Column& c) {
  c.convert(readFloatColumn(c.reader, c.count), [](float v) { return static_cast<double>(v); });
}
void readDoubles(Column& c) {
  c.each(8, [&] { return c.reader.f64(); });
}
void readBrickColors(Column& c) {
  c.convert(readUint32Column(c.reader, c.count), [](uint32_t v) { return int64_t{v}; });
}
void readEnums(Column& c) {
  c.convert(readUint32Column(c.reader, c.count), [](uint32_t v) { return EnumItem{v, {}}; });
}
void readRefs(Column& c) {
  c.convert(readReferentColumn(c.reader, c.count), [&](int32_t v) { return c.context.resolve(v); });
}

void readUDims(Column& c) {
  const auto scales = readFloatColumn(c.reader, c.count);
  const auto offsets = readInt32Column(c.reader, c.count);
  for (size_t i = 0; i < offsets.size(); ++i) c.out.emplace_back(UDim{scales[i], offsets[i]});
}

void readRanges(Column& c) {
  c.each(8, [&] {
    const float min = c.reader.f32();
    return NumberRange{min, c.reader.f32()};
  });
}

// Reads three float columns, one for each component.
std::vector<Vec3> vectors(Column& c) {
  const auto x = readFloatColumn(c.reader, c.count), y = readFloatColumn(c.reader, c.count),
             z = readFloatColumn(c.reader, c.count);
  std::vector<Vec3> out;
  out.reserve(z.size());
  for (size_t i = 0; i < z.size(); ++i) out.push_back({x[i], y[i], z[i]});
  return out;
}
void readVec3s(Column& c) {
  c.convert(vectors(c), [](Vec3 v) { return v; });
}
void readColors(Column& c) {
  c.convert(vectors(c), [](Vec3 v) { return colorFromUnit(v.x, v.y, v.z); });
}
void readByteColors(Column& c) {
  if (!c.reader.has(c.count, 3)) return;
  const std::string_view r = c.reader.bytes(c.count), g = c.reader.bytes(c.count),
                         b = c.reader.bytes(c.count);
  const auto byte = [](char v) { return static_cast<uint8_t>(v); };
  for (size_t i = 0; i < c.count; ++i)
    c.out.emplace_back(ColorRgb{byte(r[i]), byte(g[i]), byte(b[i])});
}

std::vector<CFrame> frames(Column& c) {
  if (!c.reader.has(c.count, 1 + 12)) return {};
  std::vector<CFrame> out(c.count);
  for (CFrame& frame : out) {
    if (const uint8_t id = c.reader.u8(); id != 0) {
      const auto rotation = rotationFromId(id);
      if (!rotation) c.fail("unknown rotation id " + std::to_string(id));
      frame.rotation = rotation.value_or(Mat3{});
    } else {
      std::array<float, 9> rows{};
      for (float& r : rows) r = c.reader.f32();
      frame.rotation = rotationFromRows(rows);
    }
    if (!c.reader.ok()) return {};
  }
  const std::vector<Vec3> positions = vectors(c);
  if (positions.size() < out.size()) return {};
  for (size_t i = 0; i < out.size(); ++i) out[i].position = positions[i];
  return out;
}
void readCFrames(Column& c) {
  c.convert(frames(c), [](const CFrame& f) { return f; });
}
void readOptionalCFrames(Column& c) {
  if (c.reader.u8() != 0x10)
    return c.fail("expected a CFrame column inside the OptionalCFrame column");
  const std::vector<CFrame> all = frames(c);
  if (c.reader.u8() != 0x02) return c.fail("expected a bool column after the CFrames");
  if (!c.reader.has(c.count)) return;
  for (const CFrame& frame : all) {
    c.out.push_back(c.reader.u8() != 0 ? Value{frame} : Value{});
  }
}

// Bit 0: five floats follow. Bit 1: one more (acoustic absorption), but only with bit 0.
PhysicalProperties readPhysicalProperties(ByteReader& reader) {
  PhysicalProperties p;
  const uint8_t flags = reader.u8();
  p.custom = (flags & 1) != 0;
  if (!p.custom) return p;
  for (float* field :
       {&p.density, &p.friction, &p.elasticity, &p.frictionWeight, &p.elasticityWeight}) {
    *field = reader.f32();
  }
  if ((flags & 2) != 0) reader.f32();
  return p;
}
void readPhysical(Column& c) {
  c.each(1, [&] { return readPhysicalProperties(c.reader); });
}

void readSharedStrings(Column& c) {
  for (const uint32_t index : readUint32Column(c.reader, c.count)) {
    if (index >= c.context.sharedStrings.size()) {
      return c.fail("refers to the missing shared string " + std::to_string(index));
    }
    c.out.emplace_back(SharedBlob{c.context.sharedStrings[index]});
  }
}

// Reads index (u32), time (u32) and random (u64 with its sign in the lowest bit), each with the
// most significant byte first. The text is that of XML: random, time, index.
void readUniqueIds(Column& c) {
  if (!c.reader.has(c.count, 16)) return;
  const std::string_view raw = c.reader.bytes(c.count * 16);
  for (size_t i = 0; i < c.count; ++i) {
    const auto number = [&](size_t first, size_t bytes) {
      uint64_t n = 0;
      for (size_t b = first; b < first + bytes; ++b) n = n << 8 | uint8_t(raw[b * c.count + i]);
      return n;
    };
    c.out.emplace_back(
        fmt::format("{:016x}{:08x}{:08x}", std::rotr(number(8, 8), 1), number(4, 4), number(0, 4)));
  }
}

void skipFonts(Column& c) {
  c.each(4 + 2 + 1 + 4, [&] {
    c.reader.string();  // family
    c.reader.bytes(3);  // weight, style
    c.reader.string();  // cached face
    return std::monostate{};
  });
}

// Reads the source of each value, then the addresses, then the objects inside and outside of the
// file.
void readContents(Column& c) {
  constexpr uint32_t kUri = 1, kObject = 2;
  const std::vector<uint32_t> sources = readUint32Column(c.reader, c.count);
  std::vector<std::string_view> uris;
  const uint32_t uriCount = c.reader.u32();
  if (!c.reader.has(uriCount, 4)) return;
  for (uint32_t i = 0; i < uriCount; ++i) uris.push_back(c.reader.string());
  const std::vector<int32_t> objects = readReferentColumn(c.reader, c.reader.u32());
  readReferentColumn(c.reader, c.reader.u32());
  if (!c.reader.ok()) return;
  size_t uri = 0, object = 0;
  for (const uint32_t source : sources) {
    if ((source == kUri && uri >= uris.size()) || (source == kObject && object >= objects.size())) {
      return c.fail("the file is damaged: it has more content values than addresses");
    }
    if (source == kUri) {
      c.out.emplace_back(std::string(uris[uri++]));
    } else if (source == kObject) {
      c.out.emplace_back(c.context.resolve(objects[object++]));
    } else {
      c.out.emplace_back(std::string());
    }
  }
}

struct BinaryKind {
  uint8_t id;
  void (*read)(Column&);
};

constexpr BinaryKind kBinaryKinds[] = {
    {0x01, readStrings},
    {0x02, readBools},
    {0x03, readInts},
    {0x04, readFloats},
    {0x05, readDoubles},
    {0x06, readUDims},
    {0x07, [](Column& c) { c.skipFixed(16); }},  // UDim2
    {0x08, [](Column& c) { c.skipFixed(24); }},  // Ray
    {0x09, [](Column& c) { c.skipFixed(1); }},   // Faces
    {0x0a, [](Column& c) { c.skipFixed(1); }},   // Axes
    {0x0b, readBrickColors},
    {0x0c, readColors},
    {0x0d, [](Column& c) { c.skipFixed(8); }},  // Vector2
    {0x0e, readVec3s},
    {0x10, readCFrames},
    {0x12, readEnums},
    {0x13, readRefs},
    {0x14, [](Column& c) { c.skipFixed(6); }},      // Vector3int16
    {0x15, [](Column& c) { c.skipKeypoints(3); }},  // NumberSequence
    {0x16, [](Column& c) { c.skipKeypoints(5); }},  // ColorSequence
    {0x17, readRanges},
    {0x18, [](Column& c) { c.skipFixed(16); }},  // Rect
    {0x19, readPhysical},
    {0x1a, readByteColors},
    {0x1b, readInt64s},
    {0x1c, readSharedStrings},
    {0x1d, readStrings},  // bytecode
    {0x1e, readOptionalCFrames},
    {0x1f, readUniqueIds},
    {0x20, skipFonts},
    {0x21, readInt64s},  // security capabilities
    {0x22, readContents},
};

const BinaryKind* findBinaryKind(uint8_t id) {
  for (const BinaryKind& kind : kBinaryKinds) {
    if (kind.id == id) return &kind;
  }
  return nullptr;
}

}  // namespace

Ref ColumnContext::resolve(int32_t referent) const {
  const auto it = instances.find(referent);
  return {it == instances.end() ? kNoInstance : it->second};
}

bool isKnownKind(uint8_t kind) { return findBinaryKind(kind) != nullptr; }

std::string readColumn(uint8_t kind, size_t count, ByteReader& reader, const ColumnContext& context,
                       std::vector<Value>& out) {
  Column column{count, reader, context, out};
  findBinaryKind(kind)->read(column);
  if (!column.problem.empty()) return column.problem;
  if (!reader.ok() || out.size() != count) {
    return "the data ends early: expected " + std::to_string(count) + " values";
  }
  return {};
}

}  // namespace obby::importer
