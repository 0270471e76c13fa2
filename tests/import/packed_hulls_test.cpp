// Collision hulls of CSGPHS 8: packed, some of them coded by the Edgebreaker method.
#include "import/format/packed_hulls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <algorithm>

#include "import/format/csg_physics.h"
#include "import/scene.h"
#include "support/place_columns.h"

namespace obby::test {
namespace {

using namespace importer;
using testing::HasSubstr;
using Hull = std::vector<Vec3>;

// A hull, and the Edgebreaker symbols (C, R, L, S or E) of its triangles.
struct Coded {
  Hull corners;
  std::string symbols;
};

// Returns a fan of triangles. Each corner beyond the first three adds a C, and later an R.
Coded fan(const Hull& corners) {
  const size_t more = corners.size() - 3;
  return {corners, std::string(more, 'C') + std::string(more, 'R') + 'E'};
}

Hull box(Vec3 at, Vec3 half) {
  Hull out;
  for (const float x : {-1.0f, 1.0f})
    for (const float y : {-1.0f, 1.0f})
      for (const float z : {-1.0f, 1.0f})
        out.push_back(at + Vec3{x * half.x, y * half.y, z * half.z});
  return out;
}

const Hull kTetrahedron = {{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}, {0, 0, 1}};

std::string bitsOf(const std::vector<Coded>& hulls) {
  std::string bits;
  for (const Coded& hull : hulls)
    for (const char symbol : hull.symbols)
      bits += symbol == 'C'   ? "0"
              : symbol == 'S' ? "100"
              : symbol == 'L' ? "101"
              : symbol == 'R' ? "110"
                              : "111";
  return bits;
}

std::string wordsOf(const std::string& bits) {
  std::string out;
  for (size_t at = 0; at < bits.size(); at += 32) {
    uint32_t word = 0;
    for (const char bit : bits.substr(at, 32)) word = word << 1 | uint32_t(bit - '0');
    append(out, word);
  }
  return out;
}

void appendCorners(std::string& out, const Hull& hull) {
  for (const Vec3 v : hull)
    for (const float f : {v.x, v.y, v.z}) appendFloat(out, f);
}

std::string plainBlock(const std::vector<Hull>& hulls) {
  if (hulls.empty()) return {};
  std::string out, corners;
  append(out, uint32_t(hulls.size() + 1));
  for (size_t i = 0; i <= hulls.size(); ++i) append(out, uint32_t(3 * i));
  for (size_t i = 0; i < 3 * hulls.size(); ++i) append(out, uint32_t(i % 3));
  append(out, uint32_t(hulls.size() + 1));
  uint32_t start = 0;
  append(out, start);
  for (const Hull& hull : hulls) {
    append(out, start += uint32_t(3 * hull.size()));
    appendCorners(corners, hull);
  }
  return out + corners;
}

std::string unpacked(const std::vector<Hull>& plain, const std::vector<Coded>& coded) {
  uint32_t corners = 0, faces = 0, maxCorners = 0, maxFaces = 0;
  std::string positions;
  for (const Coded& hull : coded) {
    corners += uint32_t(hull.corners.size());
    faces += uint32_t(hull.symbols.size() + 1);
    maxCorners = std::max(maxCorners, uint32_t(hull.corners.size()));
    maxFaces = std::max(maxFaces, uint32_t(hull.symbols.size() + 1));
    appendCorners(positions, hull.corners);
  }
  const std::string block = plainBlock(plain), bits = bitsOf(coded), words = wordsOf(bits);
  std::string out;
  for (const size_t field :
       {coded.size(), size_t(corners), size_t(faces), size_t(maxCorners), size_t(maxFaces),
        block.size(), bits.size(), words.size(), positions.size()})
    append(out, uint32_t(field));
  out.append(6 * 4, '\0');  // the bounding box
  return out + block + words + positions;
}

std::string packed(const std::string& content) {
  std::string frame(ZSTD_compressBound(content.size()), '\0');
  frame.resize(ZSTD_compress(frame.data(), frame.size(), content.data(), content.size(), 3));
  return frame;
}

std::string blobOf(const std::string& content) {
  std::string out = "CSGPHS";
  append(out, 8);
  out += '\1';
  out += '\0';
  return out + packed(content);
}

TEST(PackedHulls, PlainHullsPrecedeCodedHulls) {
  const Hull cube = box({0, 3, 0}, {1, 1, 1});
  const auto collision =
      decodeCollision(blobOf(unpacked({kTetrahedron, cube}, {fan(cube), fan(kTetrahedron)})));
  ASSERT_TRUE(collision) << collision.error().text();
  EXPECT_EQ(collision->kind, CollisionKind::Hulls);
  EXPECT_EQ(collision->detail, "CSGPHS 8, 4 hulls");
  EXPECT_EQ(collision->hulls, (std::vector<Hull>{kTetrahedron, cube, cube, kTetrahedron}));
}

TEST(PackedHulls, AHullEndsWithItsLastBranch) {
  const Coded branched = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}},
                          "CCSCEREC"};
  Coded ended = branched;
  ended.symbols = "CCSCERE";
  const auto hulls = decodePackedHulls(unpacked({}, {ended, fan(kTetrahedron), ended}));
  ASSERT_TRUE(hulls) << hulls.error().text();
  EXPECT_EQ(*hulls, (std::vector<Hull>{ended.corners, kTetrahedron, ended.corners}));
  // The last C lies past the end of its hull, so the next hull has one corner too many.
  EXPECT_FALSE(decodePackedHulls(unpacked({}, {branched, fan(kTetrahedron)})));
}

TEST(PackedHulls, SymbolsContinueAcrossWords) {
  std::vector<Coded> coded;
  std::vector<Hull> expected;
  for (int i = 0; i < 40; ++i) {
    Hull hull = box({float(3 * i), 0, 0}, {1, 1, 1});
    hull.resize(size_t(4 + i % 5));
    coded.push_back(fan(hull));
    expected.push_back(hull);
    const auto hulls = decodePackedHulls(unpacked({}, coded));
    ASSERT_TRUE(hulls) << i << ": " << hulls.error().text();
    EXPECT_EQ(*hulls, expected) << i;
  }
}

TEST(PackedHulls, EveryTruncationIsAnError) {
  const std::string content =
      unpacked({kTetrahedron}, {fan(box({0, 0, 0}, {1, 1, 1})), fan(kTetrahedron)});
  for (size_t length = 0; length < content.size(); ++length)
    EXPECT_FALSE(decodePackedHulls(std::string_view(content).substr(0, length))) << length;
  const std::string blob = blobOf(content);
  for (size_t length = 1; length < blob.size(); ++length)
    EXPECT_FALSE(decodeCollision(std::string_view(blob).substr(0, length))) << length;
}

TEST(PackedHulls, CountsThatDisagreeAreErrors) {
  const std::string content = unpacked({kTetrahedron}, {fan(kTetrahedron)});
  ASSERT_TRUE(decodePackedHulls(content));
  for (size_t field = 0; field < 9; ++field) {
    const bool isOnlyAHint =
        field == 3 || field == 4;  // these fields are the largest counts of any hull
    for (const char value : {'\0', '\x7f', '\xff'}) {
      std::string bad = content;
      bad.replace(4 * field, 4, 4, value);
      EXPECT_EQ(bool(decodePackedHulls(bad)), isOnlyAHint) << field << " " << int(value);
    }
  }
}

TEST(PackedHulls, ADecompressionBombIsRefused) {
  const auto bomb = decodeCollision(blobOf(std::string(size_t{64} << 20, '\0')));
  ASSERT_FALSE(bomb);
  EXPECT_THAT(bomb.error().text(), HasSubstr("more than its size allows"));
  std::string blob = blobOf(unpacked({}, {fan(kTetrahedron)}));
  blob[13] = 'x';
  EXPECT_THAT(decodeCollision(blob).error().text(), HasSubstr("zstd"));
}

TEST(PackedHulls, AUnionCollidesAsItsHulls) {
  Scene scene;
  const InstanceId arch = scene.part("Arch", {0, 5, 0}, scene.workspace, "UnionOperation");
  scene.set(arch, "Size", Vec3{8, 4, 2});
  scene.set(arch, "InitialSize", Vec3{4, 4, 2});
  const std::string blob = blobOf(
      unpacked({}, {fan(box({-1.5f, 0, 0}, {0.5f, 2, 1})), fan(box({1.5f, 0, 0}, {0.5f, 2, 1}))}));
  scene.set(arch, "PhysicalConfigData", SharedBlob{std::make_shared<const std::string>(blob)});
  scene.level();
  EXPECT_EQ(scene[arch].hulls.size(), 2u);
  EXPECT_EQ(scene[arch].hulls[0][0], (Vec3{-4, -2, -1}));
  EXPECT_EQ(scene.unmodelled("shape of a mesh or union"), 0u);
}

}  // namespace
}  // namespace obby::test
