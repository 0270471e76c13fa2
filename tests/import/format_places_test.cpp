// Tests real files, if present: binary and XML files of the same content, and whole places.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/classes/class_defaults.h"
#include "import/format/csg_physics.h"
#include "import/format/read_document.h"
#include "import/parts/hulls.h"
#include "support/document_text.h"
#include "support/read_bytes.h"

namespace obby::test {
namespace {

using namespace importer;
namespace fs = std::filesystem;

const fs::path kPlaces = fs::path(OBBY_SOURCE_DIR) / ".." / "shared" / "places";

#define SKIP_WITHOUT_PLACES()                                                                   \
  if (!fs::is_directory(kPlaces)) {                                                             \
    GTEST_SKIP() << "NOT TESTED: real place files are missing: " << kPlaces.lexically_normal(); \
  }

Document readOrDie(const fs::path& path) {
  Result<Document> document = readDocument(readBytes(path), path.filename().string());
  EXPECT_TRUE(document) << document.error().text();
  return document ? *std::move(document) : Document{};
}

// Returns the known difference that a line shows, or an empty string. The two files of a pair were
// saved at different moments.
std::string knownDifference(const std::string& line) {
  for (const char* part : {":FilteredSelection[", "/Part:Part[0].CFrame = "}) {
    if (line.find(part) != std::string::npos) return part;
  }
  return {};
}

bool isKnown(const std::string& pair, const std::string& line) {
  const std::string known = knownDifference(line);
  return !known.empty() && (pair.find("baseplate") == 0 || pair == "default-inserted-part");
}

TEST(FormatPairs, BinaryAndXmlGiveTheSameDocument) {
  SKIP_WITHOUT_PLACES();
  int pairs = 0;
  for (const auto& entry : fs::directory_iterator(kPlaces / "format-pairs")) {
    const fs::path binary = entry.path();
    if (binary.extension() != ".rbxm" && binary.extension() != ".rbxl") continue;
    SCOPED_TRACE(binary.filename().string());
    const Document first = readOrDie(binary), second = readOrDie(binary.string() + "x");
    EXPECT_EQ(first.format + "x", second.format);
    std::istringstream lines(difference(first, second, 1000));
    std::string unexpected;
    for (std::string line; std::getline(lines, line);) {
      if (!isKnown(binary.stem().string(), line)) unexpected += line + "\n";
    }
    EXPECT_EQ(unexpected, "");
    EXPECT_FALSE(first.instances.empty());
    ++pairs;
  }
  EXPECT_EQ(pairs, 16);
}

TEST(FormatPlaces, EveryFileIsReadWithItsInstances) {
  SKIP_WITHOUT_PLACES();
  struct Row {
    const char* file;
    const char* format;
    size_t instances, parts;
  };
  constexpr Row kRows[] = {
      {"elithegingercat-map.rbxm", "rbxm", 1254, 1012},
      {"gamenew09-beginning.rbxmx", "rbxmx", 8, 3},
      {"gamenew09-jump.rbxmx", "rbxmx", 8, 4},
      {"gamenew09-jump_upwards.rbxmx", "rbxmx", 9, 5},
      {"gamenew09-next_stage_indicator.rbxmx", "rbxmx", 16, 5},
      {"gamenew09-obbyparts.rbxl", "rbxl", 159, 37},
      {"gamenew09-straight_piece.rbxmx", "rbxmx", 8, 3},
      {"gamenew09-straight_piece_lava.rbxmx", "rbxmx", 12, 5},
      {"hedreon-map.rbxmx", "rbxmx", 37, 7},
      {"jefferson-first-project-obby.rbxl", "rbxl", 138, 40},
      {"rbxdom-parts-1000.rbxm", "rbxm", 1001, 1000},
      {"zander-obbytest.rbxl", "rbxl", 435, 210},
  };
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.file);
    const Document document = readOrDie(kPlaces / row.file);
    EXPECT_EQ(document.format, row.format);
    EXPECT_EQ(document.instances.size(), row.instances);
    size_t parts = 0;
    for (const Instance& instance : document.instances) {
      EXPECT_FALSE(instance.className.empty());
      parts += isA(instance.className, "BasePart") ? 1 : 0;
    }
    EXPECT_EQ(parts, row.parts);
    EXPECT_THAT(document.warnings, testing::IsEmpty());
  }
}

TEST(FormatPlaces, CollisionHullsFillTheBoxOfTheirPart) {
  SKIP_WITHOUT_PLACES();
  size_t unions = 0;
  for (const char* file : {"format-pairs/unions.rbxm", "format-pairs/sharedstring.rbxmx"}) {
    for (const Instance& part : readOrDie(kPlaces / file).instances) {
      const Collision collision = collisionFrom(collisionBlobOf(part));
      if (collision.kind == CollisionKind::Absent) continue;
      ASSERT_EQ(collision.kind, CollisionKind::Hulls) << collision.detail;
      ++unions;
      const auto hulls = scaledHulls(collision.hulls, hullScaleOf(part));
      Vec3 lo = hulls.at(0).at(0), hi = lo;
      for (const auto& hull : hulls) {
        for (const Vec3 corner : hull) {
          lo = min(lo, corner);
          hi = max(hi, corner);
        }
      }
      const Vec3 size = get<Vec3>(part, "Size");
      for (int axis = 0; axis < 3; ++axis) {
        const float half = component(size, axis) / 2;
        EXPECT_NEAR(component(lo, axis), -half, 0.02f * half) << part.name;
        EXPECT_NEAR(component(hi, axis), half, 0.02f * half) << part.name;
      }
    }
  }
  EXPECT_EQ(unions, 11u);
}

TEST(FormatPlaces, TheTestPlaceHasItsWorldConstants) {
  SKIP_WITHOUT_PLACES();
  const Document document = readOrDie(kPlaces / "zander-obbytest.rbxl");
  double gravity = 0, speed = 0, jump = 0;
  size_t tagged = 0;
  for (const Instance& instance : document.instances) {
    if (instance.className == "Workspace") gravity = get<double>(instance, "Gravity");
    if (instance.className == "StarterPlayer") {
      speed = get<double>(instance, "CharacterWalkSpeed");
      jump = get<double>(instance, "CharacterJumpHeight");
    }
    tagged += instance.tags.empty() ? 0 : 1;
  }
  EXPECT_EQ(gravity, 80);
  EXPECT_EQ(speed, 54);
  EXPECT_NEAR(jump, 12, 0.01);
  EXPECT_GT(tagged, 10u);
}

}  // namespace
}  // namespace obby::test
