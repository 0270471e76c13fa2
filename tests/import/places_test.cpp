// Real place files next to the checkout (not part of the project): plausible counts, and the same
// level from the binary and the XML form. The tests are skipped without the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "import/filter.h"
#include "import/importer.h"
#include "io/read_file.h"
#include "io/stream.h"
#include "level/level.h"

namespace obby::test {
namespace {

namespace fs = std::filesystem;

const fs::path kPlacesFolder = fs::path(OBBY_SOURCE_DIR) / ".." / "shared" / "places";

#define OBBY_NEEDS_PLACES()                                                                      \
  if (!fs::exists(kPlacesFolder)) {                                                              \
    std::cerr << "NOT TESTED: " << kPlacesFolder << " is not there, so no real place file is\n"; \
    GTEST_SKIP() << "no place files at " << kPlacesFolder;                                       \
  }

importer::Import import(const fs::path& path) {
  const auto bytes = io::readFile(path.string());
  EXPECT_TRUE(bytes) << path;
  importer::ImportOptions options;
  options.explain = true;
  auto result = importer::importPlace(*bytes, path.string(), options);
  EXPECT_TRUE(result) << path << ": " << (result ? "" : result.error().text());
  return *std::move(result);
}

struct Counts {
  unsigned kills = 0, buttons = 0, checkpoints = 0, goals = 0, hulls = 0, dynamic = 0;
};
Counts count(schema::Level::Reader level) {
  Counts counts;
  for (const auto part : level.getParts()) {
    counts.kills += part.hasKill();
    counts.buttons += part.hasButton();
    counts.checkpoints += part.hasCheckpoint();
    counts.goals += part.hasGoal();
    counts.hulls += part.getHulls().size() > 0;
    counts.dynamic += !part.getAnchored();
  }
  return counts;
}

uint32_t unmodelled(schema::Level::Reader level, const std::string& kind) {
  for (const auto entry : level.getUnmodelled())
    if (std::string(entry.getKind()) == kind) return entry.getCount();
  return 0;
}

TEST(Places, EveryFileGivesALevelThatCanBeWritten) {
  OBBY_NEEDS_PLACES();
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kPlacesFolder)) {
    if (entry.path().extension().string().rfind(".rbx", 0) != 0) continue;
    ++files;
    auto result = import(entry.path());
    const auto level = result.level.reader().getLevel();
    const auto source = level.getSource();
    EXPECT_EQ(source.getPartsKept(), level.getParts().size()) << entry.path();
    EXPECT_EQ(source.getPartsRead(), source.getPartsKept() + source.getPartsCulled());
    std::string bytes;
    auto writer = io::StreamWriter::toBytes(io::Format::jsonl, &bytes);
    EXPECT_TRUE(writer.write(result.level.reader())) << entry.path();
    const auto compiled = level::Level::compile(level);
    ASSERT_TRUE(compiled) << entry.path() << ": " << compiled.error().text();
    for (auto& query : result.queries) {
      EXPECT_TRUE(writer.write(query.reader()));
      EXPECT_TRUE(level::Query::compile(query.reader().getQuery(), *compiled)) << entry.path();
    }
    EXPECT_FALSE(result.explanation.empty());
  }
  EXPECT_GE(files, 40);
}

TEST(Places, ZandersTestLevel) {
  OBBY_NEEDS_PLACES();
  auto result = import(kPlacesFolder / "zander-obbytest.rbxl");
  const auto level = result.level.reader().getLevel();
  EXPECT_FLOAT_EQ(level.getPhysics().getGravity(), 80);
  EXPECT_FLOAT_EQ(level.getPhysics().getWalkSpeed(), 54);
  EXPECT_NEAR(level.getPhysics().getJumpSpeed(), 43.82f, 0.01f);
  EXPECT_EQ(level.getParts().size(), 19u) << "only the level in Workspace";
  const Counts counts = count(level);
  EXPECT_EQ(counts.kills, 4u)
      << "three bricks, and the pad at the end: it counts the success, then kills";
  EXPECT_EQ(counts.goals, 1u);
  EXPECT_EQ(counts.checkpoints, 1u);
  ASSERT_GE(level.getSpawns().size(), 1u);
  EXPECT_EQ(std::string(level.getSpawns()[0].getName()), "StartSpawn");
  EXPECT_FLOAT_EQ(level.getSpawns()[0].getPosition().getY(), 0);
  ASSERT_EQ(result.queries.size(), 1u);
  const auto goal = result.queries[0].reader().getQuery().getGoal();
  EXPECT_FLOAT_EQ(goal.getPosition().getZ(), 105);
  EXPECT_FLOAT_EQ(goal.getSize().getX(), 18);
}

TEST(Places, JeffersonsFirstObby) {
  OBBY_NEEDS_PLACES();
  auto result = import(kPlacesFolder / "jefferson-first-project-obby.rbxl");
  const auto level = result.level.reader().getLevel();
  EXPECT_EQ(level.getParts().size(), 40u);
  EXPECT_EQ(count(level).kills, 1u) << "the script names one of fourteen parts of one name";
  EXPECT_EQ(count(level).goals, 1u);
  EXPECT_EQ(unmodelled(level, "terrain"), 0u) << "256 chunks of level ground are one block";
  EXPECT_EQ(unmodelled(level, "button"), 0u);
  EXPECT_EQ(count(level).buttons, 1u);
  EXPECT_EQ(result.queries.size(), 1u);
}

TEST(Places, PiecesOfAnObbyKit) {
  OBBY_NEEDS_PLACES();
  auto result = import(kPlacesFolder / "gamenew09-straight_piece_lava.rbxmx");
  const auto level = result.level.reader().getLevel();
  EXPECT_EQ(level.getParts().size(), 5u);
  EXPECT_EQ(count(level).kills, 2u);
  EXPECT_EQ(count(level).dynamic, 0u) << "welded to an anchored part";
  EXPECT_EQ(result.queries.size(), 1u) << "from Start to End";
}

TEST(Places, ModelFiles) {
  OBBY_NEEDS_PLACES();
  auto town = import(kPlacesFolder / "elithegingercat-map.rbxm");
  EXPECT_EQ(town.level.reader().getLevel().getSource().getPartsRead(), 1012u);
  auto blocks = import(kPlacesFolder / "hedreon-map.rbxmx");
  EXPECT_EQ(count(blocks.level.reader().getLevel()).kills, 2u);
  auto stress = import(kPlacesFolder / "rbxdom-parts-1000.rbxm");
  // All are unanchored, and far more than a level can have.
  EXPECT_EQ(count(stress.level.reader().getLevel()).dynamic, 0u);
  EXPECT_EQ(stress.level.reader().getLevel().getUnmodelled()[0].getCount(), 1000u);
}

// Returns the record as text, without the name and format of the file.
std::string content(importer::Import& result, bool positions) {
  io::RecordBuilder copy(result.level.reader());
  for (auto part : copy.root().getLevel().getParts())
    if (!positions) part.initPosition();
  auto source = copy.root().getLevel().getSource();
  source.setFile("");
  source.setFormat("");
  std::string bytes;
  auto writer = io::StreamWriter::toBytes(io::Format::jsonl, &bytes);
  EXPECT_TRUE(writer.write(copy.reader()));
  for (auto& query : result.queries) EXPECT_TRUE(writer.write(query.reader()));
  return bytes;
}

TEST(Places, BinaryAndXmlOfTheSameContentGiveTheSameLevel) {
  OBBY_NEEDS_PLACES();
  int pairs = 0;
  for (const auto& entry : fs::directory_iterator(kPlacesFolder / "format-pairs")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".rbxm" && extension != ".rbxl") continue;
    ++pairs;
    auto binary = import(entry.path());
    auto xml = import(fs::path(entry.path()).replace_extension(extension + "x"));
    // This part was inserted twice, at two places.
    const bool positions = entry.path().stem() != "default-inserted-part";
    EXPECT_EQ(content(binary, positions), content(xml, positions)) << entry.path();
  }
  EXPECT_GE(pairs, 16);
}

}  // namespace
}  // namespace obby::test
