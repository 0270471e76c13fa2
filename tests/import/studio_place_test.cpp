// Compares a place that the Studio plugin sends with the original.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "import/format/read_document.h"
#include "import/importer.h"
#include "io/json_codec.h"
#include "support/document_text.h"
#include "support/place_writer.h"

namespace obby::test {
namespace {

using Id = PlaceWriter::Id;

constexpr float kGravity = 90, kSpeed = 24;
constexpr const char* kCharacterScripts = "StarterCharacterScripts";
const std::string kScript =
    "workspace.Stage.Lava.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)";

void addWorld(PlaceWriter& writer, Id workspace) {
  const Id start = writer.add("SpawnLocation", "Start", workspace);
  writer.set(start, "Anchored", flag(true)).set(start, "size", vec3(8, 1, 8));
  const Id other = writer.add("SpawnLocation", "Pad", workspace);
  writer.set(other, "Anchored", flag(true)).set(other, "size", vec3(8, 1, 8));
  writer.set(other, "CFrame", cframe(90, 0, 0)).set(other, "Neutral", flag(false));
  writer.set(other, "TeamColor", brickNumber(21));
  const Id lava = writer.add("Part", "Lava", writer.add("Folder", "Stage", workspace));
  writer.set(lava, "Anchored", flag(true)).set(lava, "size", vec3(4, 1, 4));
  writer.set(lava, "CFrame", cframe(30, 0, 0));
}

// Adds the team in which players begin.
void addTeams(PlaceWriter& writer, Id service) {
  writer.set(writer.add("Team", "Beginners", service), "TeamColor", brickNumber(21));
}

// Adds a script for health that does not regenerate, and one for a jump.
void addCharacterScript(PlaceWriter& writer, Id folder) {
  writer.set(writer.add("Script", "Health", folder), "Source", source("-- none"));
  writer.set(writer.add("Script", "Jump", folder), "Source",
             source("script.Parent.Humanoid.JumpPower = 70"));
}

void addScript(PlaceWriter& writer, Id service) {
  writer.set(writer.add("Script", "Kill", service), "Source", source(kScript));
}

PlaceWriter wholePlace() {
  PlaceWriter writer;
  const Id workspace = writer.add("Workspace", "Workspace");
  writer.set(workspace, "Gravity", float32(kGravity));
  addWorld(writer, workspace);
  const Id player = writer.add("StarterPlayer", "StarterPlayer");
  writer.set(player, "CharacterWalkSpeed", float32(kSpeed));
  addCharacterScript(writer, writer.add("StarterCharacterScripts", kCharacterScripts, player));
  addTeams(writer, writer.add("Teams", "Teams"));
  addScript(writer, writer.add("ServerScriptService", "ServerScriptService"));
  return writer;
}

// Returns the same place as the plugin sends it. A Folder replaces each instance that scripts
// cannot make.
PlaceWriter sentPlace() {
  PlaceWriter writer;
  const Id place = writer.add("Configuration", "ObbyPlace");
  const Id workspace = writer.add("Configuration", "Workspace", place);
  writer.attribute(workspace, "Gravity", double(kGravity));
  const Id player = writer.add("Configuration", "StarterPlayer", place);
  writer.attribute(player, "CharacterWalkSpeed", double(kSpeed));
  addCharacterScript(writer, writer.add("Folder", kCharacterScripts, player));
  addTeams(writer, writer.add("Configuration", "Teams", place));
  addScript(writer, writer.add("Configuration", "ServerScriptService", place));
  addWorld(writer, kNoInstance);
  return writer;
}

std::string levelOf(const std::string& bytes) {
  auto made = importer::importPlace(bytes, "level.rbxl", {});
  if (!made) return made.error().text();
  auto level = made->level.root().getLevel();
  for (auto part : level.getParts()) part.getSource().initIndices(0);  // ObbyPlace moves them
  level.getSource().setFormat("");
  return *io::recordToJson(made->level.reader());
}

TEST(StudioPlace, is_read_as_its_place) {
  const auto read = importer::readDocument(sentPlace().binary(), "sent");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->format, "rbxl");
  const std::string level = levelOf(sentPlace().binary());
  EXPECT_EQ(level, levelOf(wholePlace().binary()));
  EXPECT_EQ(level, levelOf(sentPlace().xml()));
  EXPECT_THAT(level, testing::HasSubstr("Workspace/Stage/Lava"));
  EXPECT_THAT(level, testing::HasSubstr("\"gravity\":90"));
  EXPECT_THAT(level, testing::HasSubstr("\"walkSpeed\":24"));
  EXPECT_THAT(level, testing::HasSubstr("script Kill line 1"));
  EXPECT_THAT(level, testing::HasSubstr("\"healthRegeneration\":0}"));
  EXPECT_THAT(level, testing::HasSubstr("\"jumpSpeed\":74.2"));
  EXPECT_THAT(level, testing::HasSubstr("\"spawns\":[{\"name\":\"Pad\""));
}

TEST(StudioPlace, a_similar_model_stays_a_model) {
  PlaceWriter writer;
  const Id place = writer.add("Configuration", "ObbyPlace");
  writer.add("Configuration", "Lighting", place);
  writer.add("Folder", "Workspace", place);
  writer.add("Part", "Alone");
  const auto read = importer::readDocument(writer.binary(), "model");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->format, "rbxm");
  EXPECT_EQ(read->roots.size(), 2u);
}

}  // namespace
}  // namespace obby::test
