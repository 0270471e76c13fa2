// Decodes "CSGPHS", a u32 version, and then a body by version.
//   0: "BLOCK"
//   3 and 5: hulls to the end
//   6: mass properties, then one hull
//   7: a byte for the kind of decomposition, mass properties, hulls
//   8: that byte, a zero, packed hulls
// A hull of the versions up to 7 has 40 constant bytes, u32 number of floats, u32 4, the floats (x
// y z for each corner), u32 number of indices, u32 indices (three for each triangle).
#include "import/format/csg_physics.h"

#include <cmath>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "import/format/byte_reader.h"
#include "import/format/packed_hulls.h"

namespace obby::importer {
namespace {

constexpr std::string_view kMagic = "CSGPHS";
constexpr std::string_view kKeyMagic = "CSGK";
constexpr size_t kHullHeader = 40;
constexpr size_t kMassProperties = 10 * 4;  // volume, centre (3), inertia (6)
constexpr size_t kFewestCorners = 4;
constexpr uint32_t kPackedVersion = 8;

Error damaged(const ByteReader& reader, std::string message) {
  return Error{{}, "byte " + std::to_string(reader.position()), "CSGPHS", std::move(message), {}};
}

Result<std::vector<Vec3>> readHull(ByteReader& reader) {
  reader.bytes(kHullHeader);
  const uint32_t floats = reader.u32();
  const uint32_t width = reader.u32();
  if (!reader.has(floats, 4) || width != 4 || floats % 3 != 0) {
    return damaged(reader, "expected the corners of a hull");
  }
  std::vector<Vec3> corners(floats / 3);
  for (Vec3& corner : corners) {
    const float x = reader.f32(), y = reader.f32(), z = reader.f32();
    corner = {x, y, z};
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
      return damaged(reader, "a corner is not finite");
    }
  }
  const uint32_t indices = reader.u32();
  if (!reader.has(indices, 4)) return damaged(reader, "expected the triangles of a hull");
  for (uint32_t i = 0; i < indices; ++i) {
    if (reader.u32() >= corners.size())
      return damaged(reader, "a triangle refers to a corner that does not exist");
  }
  return corners;
}

// Skips the data before the hulls. Returns false for unknown versions.
bool skipToHulls(uint32_t version, ByteReader& reader) {
  if (version == 3 || version == 5) return true;
  if (version != 6 && version != 7) return false;
  reader.bytes((version == 7 ? 1 : 0) + kMassProperties);
  return true;
}

// Reads hulls of the versions up to 7.
Result<std::vector<std::vector<Vec3>>> readHulls(ByteReader& reader) {
  std::vector<std::vector<Vec3>> hulls;
  while (reader.ok() && reader.remaining() > 0) {
    OBBY_ASSIGN(std::vector<Vec3> corners, readHull(reader));
    hulls.push_back(std::move(corners));
  }
  if (!reader.ok()) return damaged(reader, "the data ends early");
  return hulls;
}

Result<std::vector<std::vector<Vec3>>> readPackedHulls(ByteReader& reader) {
  reader.bytes(2);  // the kind of decomposition, and a zero
  if (!reader.ok()) return damaged(reader, "the data ends early");
  OBBY_ASSIGN(const std::string unpacked, unpackHulls(reader.bytes(reader.remaining())));
  return decodePackedHulls(unpacked);
}

Collision unsupported(std::string detail) {
  return {CollisionKind::Unsupported, std::move(detail), {}};
}

float scaleOf(float size, float initial) {
  const float scale = size / initial;
  return initial > 0 && std::isfinite(scale) ? scale : 1.0f;
}

}  // namespace

Result<Collision> decodeCollision(std::string_view blob) {
  if (blob.empty()) return Collision{};
  if (blob.substr(0, kKeyMagic.size()) == kKeyMagic) {
    return unsupported("CSGK names hulls that are not in the file");
  }
  ByteReader reader(blob);
  if (reader.bytes(kMagic.size()) != kMagic)
    return damaged(reader, "expected the signature CSGPHS");
  const uint32_t version = reader.u32();
  if (!reader.ok()) return damaged(reader, "the data ends before its version");
  const std::string name = "CSGPHS " + std::to_string(version);
  if (version == 0) {
    if (reader.bytes(5) != "BLOCK") return damaged(reader, "expected BLOCK");
    return Collision{CollisionKind::Box, name + ", a box", {}};
  }
  const bool packed = version == kPackedVersion;
  if (!packed && !skipToHulls(version, reader)) return unsupported(name + " is not supported");
  Collision out;
  out.kind = CollisionKind::Hulls;
  OBBY_ASSIGN(out.hulls, packed ? readPackedHulls(reader) : readHulls(reader));
  std::erase_if(out.hulls, [](const auto& hull) { return hull.size() < kFewestCorners; });
  if (out.hulls.empty()) return unsupported(name + " has no hulls");
  out.detail = name + ", " + std::to_string(out.hulls.size()) + " hulls";
  return out;
}

CollisionBlob collisionBlobOf(const Instance& part) {
  for (const char* name : {"PhysicalConfigData", "PhysicsData"}) {
    const auto* shared = property<SharedBlob>(part, name);
    const auto* own = property<std::string>(part, name);
    const std::string_view bytes = shared ? *shared->bytes : own ? *own : std::string_view();
    if (!bytes.empty()) return {name, bytes, shared != nullptr};
  }
  return {};
}

Collision collisionFrom(const CollisionBlob& blob) {
  Result<Collision> decoded = decodeCollision(blob.bytes);
  if (!decoded) return unsupported(std::string(blob.property) + ": " + decoded.error().text());
  return *std::move(decoded);
}

Vec3 hullScaleOf(const Instance& part) {
  const Vec3 size = get<Vec3>(part, "Size"), initial = get<Vec3>(part, "InitialSize");
  return {scaleOf(size.x, initial.x), scaleOf(size.y, initial.y), scaleOf(size.z, initial.z)};
}

}  // namespace obby::importer
