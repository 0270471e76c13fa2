// Stage queries and the level record: the importer's output.
#include "import/records/queries.h"

#include <cmath>

#include "import/importer.h"
#include "import/records/level_record.h"
#include "import/scene.h"
#include "io/stream.h"
#include "level/level.h"

namespace obby::test {
namespace {

PartDraft pad(Vec3 position, Vec3 size, Mat3 rotation = {}) {
  PartDraft part;
  part.pose = {position, rotation};
  part.size = size;
  return part;
}

// Returns true if the vertical line from the feet to 5 studs above them meets the box.
bool standsIn(const importer::GoalBox& box, Vec3 feet) {
  for (float up = 0; up <= 5; up += 0.01f) {
    const Vec3 local = toLocal(box.pose, feet + Vec3{0, up, 0});
    if (absf(local.x) <= box.size.x / 2 && absf(local.y) <= box.size.y / 2 &&
        absf(local.z) <= box.size.z / 2)
      return true;
  }
  return false;
}

TEST(GoalBox, ContainsPlayersOnThePadButNotAway) {
  const auto box = importer::goalBox(pad({10, 5, 0}, {4, 1, 4}));
  EXPECT_TRUE(standsIn(box, {10, 5.5f, 0}));
  EXPECT_TRUE(standsIn(box, {12, 5.6f, 2}));
  EXPECT_TRUE(standsIn(box, {12.9f, 3, 0})) << "touching the side";
  EXPECT_FALSE(standsIn(box, {13.2f, 5.5f, 0}));
  EXPECT_FALSE(standsIn(box, {10, 6.5f, 0})) << "above it in the air";
}

TEST(GoalBox, GrowsUpwardInAnyRotation) {
  const Mat3 onSide = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  const Mat3 upsideDown = {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  EXPECT_TRUE(standsIn(importer::goalBox(pad({}, {1, 4, 4}, onSide)), {0, 0.9f, 0}));
  EXPECT_TRUE(standsIn(importer::goalBox(pad({}, {4, 1, 4}, upsideDown)), {0, 0.9f, 0}));
  EXPECT_FALSE(standsIn(importer::goalBox(pad({}, {4, 1, 4}, upsideDown)), {0, -6, 0}));
}

Scene threeStages() {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  for (int i = 1; i <= 2; ++i)
    scene.tag(scene.part("Checkpoint" + std::to_string(i), {float(i) * 20, 0, 0}), "Checkpoint");
  scene.tag(scene.part("Gate", {60, 0, 0}), "Goal");
  return scene;
}

TEST(Queries, EachStageAndTheGoalGetAQuery) {
  const Scene scene = threeStages();
  auto result = importer::importDocument(scene.document, {"tower", true, false});
  ASSERT_EQ(result.queries.size(), 3u);
  const char* goals[] = {"Checkpoint1", "Checkpoint2", "Gate"};
  for (size_t i = 0; i < 3; ++i) {
    const auto query = result.queries[i].reader().getQuery();
    EXPECT_EQ(std::string(query.getId()), "stage" + std::to_string(i + 1));
    EXPECT_EQ(std::string(query.getLevel()), "tower");
    EXPECT_EQ(query.getStart().getSpawn(), int(i));
    EXPECT_EQ(std::string(query.getGoal().getName()), goals[i]);
    EXPECT_FLOAT_EQ(query.getGoal().getPosition().getX(), 20.0f * float(i + 1));
  }
  EXPECT_TRUE(importer::importDocument(scene.document, {"tower", false, false}).queries.empty());
}

std::vector<std::string> titles(const Scene& scene) {
  std::vector<std::string> all;
  for (const auto& query : importer::importDocument(scene.document, {}).queries)
    all.emplace_back(query.reader().getQuery().getTitle());
  return all;
}

TEST(Queries, TitlesNameStartAndGoal) {
  EXPECT_EQ(titles(threeStages()),
            (std::vector<std::string>{"Stage 1: the start to 'Checkpoint1'",
                                      "Stage 2: 'Checkpoint1' to 'Checkpoint2'",
                                      "Stage 3: 'Checkpoint2' to 'Gate'"}));
}

TEST(Queries, TitlesUseNumbersOrModelsInsteadOfGenericNames) {
  Scene scene;
  scene.part("Base", {}, scene.workspace, "SpawnLocation");
  const auto folder = scene.add("Folder", "Checkpoints", scene.workspace);
  for (const int n : {17, 19}) scene.part(std::to_string(n), {float(n), 0, 0}, folder);
  for (const char* name : {"Bridge", "Tower"}) {
    const auto model = scene.add("Model", name, scene.workspace);
    const auto part = scene.part("Touch", {60, 0, 0}, model);
    scene.tag(part, name[0] == 'B' ? "Checkpoint" : "Goal");
    if (name[0] == 'B') scene.attribute(part, "Stage", int64_t{3});
  }
  for (const InstanceId id : scene.document.instances[folder].children) scene.tag(id, "Checkpoint");
  EXPECT_EQ(titles(scene),
            (std::vector<std::string>{
                "Stage 1: the start to 'Bridge'", "Stage 2: 'Bridge' to checkpoint 17",
                "Stage 3: checkpoint 17 to checkpoint 19", "Stage 4: checkpoint 19 to 'Tower'"}));
}

TEST(Queries, AGoalThatIsTheLastCheckpointIsAskedOnce) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto both = scene.part("Checkpoint", {40, 0, 0});
  scene.tag(both, "Goal");
  scene.tag(both, "Checkpoint");
  EXPECT_EQ(importer::importDocument(scene.document, {}).queries.size(), 1u);
}

TEST(Queries, ACourseWithoutCheckpointsRunsFromSpawnToGoal) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  scene.part("WinPad", {40, 0, 0});
  auto result = importer::importDocument(scene.document, {});
  ASSERT_EQ(result.queries.size(), 1u);
  EXPECT_EQ(std::string(result.queries[0].reader().getQuery().getGoal().getName()), "WinPad");
}

TEST(Queries, NothingToReachIsAWarning) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto result = importer::importDocument(scene.document, {});
  EXPECT_TRUE(result.queries.empty());
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings[0].find("no goal"), std::string::npos);
}

TEST(LevelRecord, TracesPartsToTheFile) {
  Scene scene;
  const auto folder = scene.add("Folder", "Stage/1", scene.workspace);
  scene.part("First", {}, folder);
  const auto part = scene.part("Lava", {1, 2, 3}, folder);
  scene.tag(part, "KillBrick");
  scene.set(part, "UniqueId", std::string("44b188dace632b4702e9c68d004815fc"));
  auto result = importer::importDocument(scene.document, {});
  const auto level = result.level.reader().getLevel();
  EXPECT_EQ(std::string(level.getName()), "test");
  EXPECT_EQ(std::string(level.getSource().getPath()), "Workspace");
  EXPECT_EQ(std::string(level.getSource().getFormat()), "rbxl");
  EXPECT_EQ(level.getSource().getPartsKept(), 2u);
  const auto lava = level.getParts()[1];
  EXPECT_EQ(std::string(lava.getSource().getPath()), "Workspace/Stage/1/Lava");
  ASSERT_EQ(lava.getSource().getIndices().size(), 3u);
  EXPECT_EQ(lava.getSource().getIndices()[2], 1u);
  EXPECT_EQ(std::string(lava.getSource().getClassName()), "Part");
  EXPECT_EQ(std::string(lava.getSource().getGuid()), "44b188dace632b4702e9c68d004815fc");
  EXPECT_TRUE(lava.hasKill());
  EXPECT_EQ(std::string(lava.getTags()[0]), "KillBrick");
}

TEST(LevelRecord, AnyFileContentCanBeWritten) {
  Scene scene;
  scene.part("bad \xff\xfe \xed\xa0\x80 name");
  const auto huge = scene.part("Huge");
  scene.set(huge, "Size", Vec3{1e9f, 0, 3});
  scene.set(scene.workspace, "Gravity", -5.0);
  auto result = importer::importDocument(scene.document, {});
  std::string bytes;
  auto writer = io::StreamWriter::toBytes(io::Format::jsonl, &bytes);
  const Status written = writer.write(result.level.reader());
  ASSERT_TRUE(written) << written.error().text();
  EXPECT_NE(bytes.find("\xef\xbf\xbd"), std::string::npos);
  const auto parts = result.level.reader().getLevel().getParts();
  EXPECT_FLOAT_EQ(parts[1].getSize().getX(), 2048);
  EXPECT_FLOAT_EQ(parts[1].getSize().getY(), 0.001f);
}

// Sets every number of every property to a hostile value, one at a time.
TEST(LevelRecord, HostileNumbersGiveALevelThatCompiles) {
  const double kNaN = std::nan(""), kInfinity = HUGE_VAL;
  for (const double bad : {kNaN, kInfinity, -kInfinity, -1e38, 1e38, 1e-38, -1.0, 0.0}) {
    const auto f = float(bad);
    Scene scene;
    for (const char* name : {"Gravity", "FallenPartsDestroyHeight"})
      scene.set(scene.workspace, name, bad);
    const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
    for (const char* name : {"CharacterWalkSpeed", "CharacterJumpPower", "CharacterJumpHeight",
                             "CharacterMaxSlopeAngle"})
      scene.set(player, name, bad);
    scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
    scene.part("WinPad", {20, 0, 0});
    const char* const tags[] = {"DamagePart", "Conveyor", "BouncePad",  "Disappearing",
                                "Checkpoint", "Spinner",  "MovingPart", "kills"};
    for (const char* tag : tags) {
      const auto id = scene.part("Part", {40, 0, 0});
      scene.tag(id, tag);
      for (const char* name : {"Speed", "Damage", "Cooldown", "Power", "FadeTime", "RespawnTime",
                               "Stage", "Delay", "RotationSpeed"})
        scene.attribute(id, name, bad);
      scene.set(id, "Transparency", bad);
      scene.set(id, "CustomPhysicalProperties", PhysicalProperties{true, f, f, f, f, f});
      scene.set(id, "Velocity", Vec3{f, f, f});
      scene.set(id, "RotVelocity", Vec3{f, 0, f});
    }
    scene.set(scene.part("Turning"), "RotVelocity", Vec3{f, f, 0});
    scene.set(scene.part("Big"), "Size", Vec3{f, 1, 1});
    scene.set(scene.part("Far"), "CFrame", CFrame{{f, f, f}, {}});
    scene.set(scene.part("Odd"), "CFrame", CFrame{{}, {{f, 0, 0}, {0, f, f}, {f, f, 1}}});
    scene.value("NumberValue", "N", bad, scene.scripts);
    scene.script(R"(local n = script.Parent.N.Value
local p = workspace.Part
p.Velocity = Vector3.new(n, n, n)
workspace.Gravity = n
p.Touched:Connect(function(hit) wait(n) hit.Parent.Humanoid:TakeDamage(n) p.CanCollide = false
  wait(n) p.CanCollide = true end)
game.TweenService:Create(workspace.Big, TweenInfo.new(n, 0, 0, n, true, n), {Position = Vector3.new(n, 0, 0)}):Play()
while true do workspace.Odd.CFrame = workspace.Odd.CFrame * CFrame.Angles(n, n, n) + Vector3.new(n, 0, 0) wait(n) end)",
                 scene.scripts);
    auto result = importer::importDocument(scene.document, {});
    std::string bytes;
    auto writer = io::StreamWriter::toBytes(io::Format::jsonl, &bytes);
    const Status written = writer.write(result.level.reader());
    ASSERT_TRUE(written) << bad << ": " << written.error().text();
    const auto compiled = level::Level::compile(result.level.reader().getLevel());
    ASSERT_TRUE(compiled) << bad << ": " << compiled.error().text();
  }
}

TEST(LevelRecord, Utf8IsRepairedNotDropped) {
  EXPECT_EQ(importer::validUtf8("a\xc3\xa9z"), "a\xc3\xa9z");
  EXPECT_EQ(importer::validUtf8("a\xc3"), "a\xef\xbf\xbd");
  EXPECT_EQ(importer::validUtf8(std::string("a\0b", 3)),
            "a\xef\xbf\xbd"
            "b");
}

TEST(Names, ALevelHasTheNameOfItsFile) {
  EXPECT_EQ(importer::levelName("places/My Obby.v2.rbxl"), "My Obby.v2");
  EXPECT_EQ(importer::levelName("-"), "level");
  EXPECT_EQ(importer::levelName(".rbxl"), ".rbxl");
}

}  // namespace
}  // namespace obby::test
