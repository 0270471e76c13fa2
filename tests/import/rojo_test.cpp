// Rojo projects: the importer reads a folder of files as the place that Rojo would build from them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "import/document/tree.h"
#include "import/rojo/globs.h"
#include "import/rojo/json_file.h"
#include "import/rojo/project_reader.h"
#include "support/place_writer.h"

namespace obby::test {
namespace {

namespace fs = std::filesystem;
using namespace importer;
using testing::ElementsAre;
using testing::HasSubstr;

class Rojo : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    base_ = fs::path(::testing::TempDir()) / (std::string("obby_rojo_") + test->name());
    fs::remove_all(base_);
    folder_ = base_ / "course";
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(base_); }

  void file(const std::string& name, const std::string& bytes) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  void project(const std::string& tree) {
    file("default.project.json", R"({"name": "course", "tree": )" + tree + "}");
  }
  void read() {
    auto result = rojo::readProject(folder_.string());
    ASSERT_TRUE(result) << result.error().text();
    project_ = *std::move(result);
  }
  std::string error() {
    const auto result = rojo::readProject(folder_.string());
    return result ? "" : result.error().text();
  }
  const Instance& at(const std::string& path) const {
    static const Instance kNothing;
    const Tree tree(project_.document);
    for (InstanceId id = 0; id < tree.size(); ++id)
      if (tree.path(id) == path) return tree.at(id);
    ADD_FAILURE() << "there is no " << path;
    return kNothing;
  }
  size_t size() const { return project_.document.instances.size(); }

  fs::path base_, folder_;
  rojo::Project project_;
};

TEST_F(Rojo, ServicesAndContainersAreKnownByTheirNames) {
  project(R"({"$className": "DataModel",
    "Workspace": {"$properties": {"Gravity": 100}, "Terrain": {}},
    "StarterPlayer": {"StarterPlayerScripts": {"$path": "src/client"}},
    "ReplicatedStorage": {"Shared": {"$path": "src/shared.luau"}}, // a comment
  })");
  file("src/client/run.client.luau", "print(1)\r\nprint(2)\r\n");
  file("src/shared.luau", "return {}");
  read();
  EXPECT_EQ(project_.name, "course");
  EXPECT_EQ(project_.document.format, "rojo");
  EXPECT_EQ(at("Workspace").className, "Workspace");
  EXPECT_EQ(propertyOr(at("Workspace"), "Gravity", 0.0), 100);
  EXPECT_EQ(at("Workspace/Terrain").className, "Terrain");
  EXPECT_EQ(at("StarterPlayer/StarterPlayerScripts").className, "StarterPlayerScripts");
  EXPECT_EQ(at("StarterPlayer/StarterPlayerScripts/run").className, "LocalScript");
  EXPECT_EQ(propertyOr(at("StarterPlayer/StarterPlayerScripts/run"), "Source", std::string()),
            "print(1)\nprint(2)\n");
  EXPECT_EQ(at("ReplicatedStorage/Shared").className, "ModuleScript");
}

TEST_F(Rojo, FilesBecomeInstancesByTheEndsOfTheirNames) {
  project(R"({"$path": "src"})");
  file("src/a.server.lua", "");
  file("src/b.plugin.luau", "");
  file("src/c.lua", "return 1");
  file("src/d.json", R"({"speed": 2.5, "list": [true, "x"], "none": null})");
  file("src/e.toml", "a = 1");
  file("src/f.txt", "hello");
  file("src/g.csv", "Key,Source");
  file("src/h.md", "nothing");
  file("src/i.model.json", R"({"ClassName": "Part", "Properties": {"Anchored": true}})");
  file("src/j/init.server.luau", "print()");
  file("src/j/k.luau", "return 2");
  file("src/j/init.meta.json", R"({"properties": {"Disabled": true}})");
  file("src/l/init.meta.json", R"({"className": "Model", "attributes": {"Speed": 3}})");
  file("src/m.lua", "");
  file("src/m.meta.json", R"({"attributes": {"Key": "v"}})");
  read();
  const std::pair<const char*, const char*> kExpected[] = {
      {"course", "Folder"},           {"course/a", "Script"},
      {"course/b", "Script"},         {"course/c", "ModuleScript"},
      {"course/d", "ModuleScript"},   {"course/e", "ModuleScript"},
      {"course/f", "StringValue"},    {"course/g", "LocalizationTable"},
      {"course/i", "Part"},           {"course/j", "Script"},
      {"course/j/k", "ModuleScript"}, {"course/l", "Model"},
      {"course/m", "ModuleScript"}};
  for (const auto& [path, className] : kExpected) EXPECT_EQ(at(path).className, className) << path;
  EXPECT_EQ(size(), std::size(kExpected));
  EXPECT_EQ(propertyOr(at("course/b"), "RunContext", EnumItem{}).value, 3u);
  EXPECT_EQ(propertyOr(at("course/d"), "Source", std::string()),
            "return {[\"speed\"] = 2.5, [\"list\"] = {true, \"x\", }, [\"none\"] = nil, }\n");
  EXPECT_EQ(propertyOr(at("course/f"), "Value", std::string()), "hello");
  EXPECT_TRUE(propertyOr(at("course/j"), "Disabled", false));
  EXPECT_EQ(std::get<double>(at("course/l").attributes.at("Speed")), 3);
  EXPECT_EQ(std::get<std::string>(at("course/m").attributes.at("Key")), "v");
}

TEST_F(Rojo, PropertiesAreReadByTheirKind) {
  project(R"({"$className": "Folder", "Lava": {"$className": "Part", "$properties": {
      "Anchored": true, "Size": [4, 1, 6], "Color": [1, 0.5, 0], "Material": "Neon",
      "Shape": "Ball", "Transparency": 0.5, "Tags": ["KillBrick", "Hot"],
      "CFrame": [1, 2, 3, 0, 0, 1, 0, 1, 0, -1, 0, 0],
      "CustomPhysicalProperties": {"PhysicalProperties": {"density": 1, "friction": 0.1,
        "elasticity": 0, "frictionWeight": 2, "elasticityWeight": 1}}},
      "$attributes": {"Damage": 5, "At": {"Vector3": [1, 2, 3]}}},
    "Turned": {"$className": "Part", "$properties": {
      "CFrame": {"CFrame": {"position": [1, 2, 3], "orientation": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]}},
      "Size": {"Vector3": [1, 2, 3]}, "Color": {"Color3uint8": [1, 2, 3]}, "Shape": {"Enum": 2}}}})");
  read();
  const Instance& lava = at("course/Lava");
  EXPECT_EQ(propertyOr(lava, "Size", Vec3{}), (Vec3{4, 1, 6}));
  EXPECT_EQ(propertyOr(lava, "Color", ColorRgb{}).g, 128);
  EXPECT_EQ(propertyOr(lava, "Material", EnumItem{}).value, 288u);
  EXPECT_EQ(propertyOr(lava, "Shape", EnumItem{1, {}}).value, 0u);
  EXPECT_EQ(propertyOr(lava, "Transparency", 0.0), 0.5);
  EXPECT_EQ(lava.tags, (std::vector<std::string>{"KillBrick", "Hot"}));
  EXPECT_EQ(propertyOr(lava, "CFrame", CFrame{}).rotation * (Vec3{1, 0, 0}), (Vec3{0, 0, -1}));
  EXPECT_EQ(propertyOr(lava, "CustomPhysicalProperties", PhysicalProperties{}).frictionWeight, 2);
  EXPECT_EQ(std::get<double>(lava.attributes.at("Damage")), 5);
  EXPECT_EQ(std::get<Vec3>(lava.attributes.at("At")), (Vec3{1, 2, 3}));
  const Instance& turned = at("course/Turned");
  EXPECT_EQ(propertyOr(turned, "CFrame", CFrame{}).rotation * (Vec3{1, 0, 0}), (Vec3{0, 0, -1}));
  EXPECT_EQ(propertyOr(turned, "Size", Vec3{}), (Vec3{1, 2, 3}));
  EXPECT_EQ(propertyOr(turned, "Color", ColorRgb{}).b, 3);
  EXPECT_EQ(propertyOr(turned, "Shape", EnumItem{}).value, 2u);
}

TEST_F(Rojo, ModelFilesBringTheirInstances) {
  PlaceWriter writer;
  const auto model = writer.add("Model", "Old name");
  writer.add("Part", "Pad", model);
  file("map/Stage.rbxm", writer.binary());
  file("map/Other.rbxmx", writer.xml());
  file("map/Two.model.json", R"({"className": "Model", "children": [
      {"className": "Part", "name": "A"}, {"ClassName": "Part", "Children": [{"ClassName": "Fire"}]}]})");
  project(
      R"({"$className": "DataModel", "Workspace": {"Map": {"$path": "map", "Extra": {"$className": "Part"}}}})");
  read();
  EXPECT_EQ(at("Workspace/Map/Stage").className, "Model");
  EXPECT_EQ(at("Workspace/Map/Stage/Pad").className, "Part");
  EXPECT_EQ(at("Workspace/Map/Other/Pad").className, "Part");
  EXPECT_EQ(at("Workspace/Map/Two/A").className, "Part");
  EXPECT_EQ(at("Workspace/Map/Two/Part/Fire").className, "Fire");
  EXPECT_EQ(at("Workspace/Map/Extra").className, "Part");
}

TEST_F(Rojo, ProjectsInFoldersAndSettings) {
  file("default.project.json", R"({"name": "course", "emitLegacyScripts": false,
    "globIgnorePaths": ["**/*.spec.luau", "src/old/**"],
    "tree": {"$className": "DataModel", "ServerScriptService": {"$path": "src"},
      "ReplicatedStorage": {"Gone": {"$path": {"optional": "gone"}}}}})");
  file("src/a.server.luau", "");
  file("src/a.spec.luau", "");
  file("src/b.client.luau", "");
  file("src/old/c.luau", "");
  file("src/Package/default.project.json", R"({"name": "p", "tree": {"$path": "lib"}})");
  file("src/Package/lib/init.luau", "return {}");
  file("src/Package/tests/d.luau", "");
  read();
  EXPECT_EQ(propertyOr(at("ServerScriptService/a"), "RunContext", EnumItem{}).value, 1u);
  EXPECT_EQ(at("ServerScriptService/b").className, "Script");
  EXPECT_EQ(propertyOr(at("ServerScriptService/b"), "RunContext", EnumItem{}).value, 2u);
  EXPECT_EQ(at("ServerScriptService/Package").className, "ModuleScript");
  EXPECT_EQ(at("ServerScriptService/old").children.size(), 0u);
  EXPECT_EQ(size(), 6u);
}

TEST_F(Rojo, NothingOutsideIsReadUnlessTheProjectSaysSo) {
  std::ofstream(base_ / "secret.txt") << "secret";
  fs::create_directories(base_ / "shared");
  std::ofstream(base_ / "shared" / "a.luau") << "return 1";
  project(R"({"$className": "Folder", "Shared": {"$path": "../shared"}})");
  read();
  EXPECT_EQ(at("course/Shared/a").className, "ModuleScript");
  project(R"({"$path": "src"})");
  file("src/a.luau", "");
  fs::create_symlink(base_ / "secret.txt", folder_ / "src" / "b.txt");
  EXPECT_THAT(error(), HasSubstr("b.txt: leads out of the project's folder"));
  fs::remove(folder_ / "src" / "b.txt");
  file("src/c/default.project.json", R"({"name": "c", "tree": {"$path": "../../../secret.txt"}})");
  EXPECT_THAT(error(), HasSubstr("leads out of the project's folder"));
  fs::remove_all(folder_ / "src" / "c");
  fs::create_directory_symlink(folder_ / "src", folder_ / "src" / "loop");
  read();
  EXPECT_EQ(size(), 2u);
  EXPECT_THAT(project_.document.warnings,
              ElementsAre(HasSubstr("loop: the folder contains itself")));
}

TEST_F(Rojo, ErrorsNameTheFileAndTheKeys) {
  EXPECT_THAT(error(), HasSubstr("contains default.project.json"));
  project(R"({"Part": )");
  EXPECT_THAT(error(), HasSubstr("default.project.json: "));
  project(R"({"$className": "Folder", "A": {"$className": "Folder", "B": {"$path": "missing"}}})");
  EXPECT_THAT(error(), HasSubstr("tree.A.B.$path: there is no file or folder"));
  project(R"({"$className": "Folder", "A": 5})");
  EXPECT_THAT(error(), HasSubstr("tree.A: expected an object, found 5"));
  project(R"({"$className": "Folder", "A": {}})");
  EXPECT_THAT(error(), HasSubstr("tree.A: the node has no class"));
  project(R"({"$className": "Part", "$path": "a.luau"})");
  file("a.luau", "");
  EXPECT_THAT(error(),
              HasSubstr("tree.$className: does not match the $path, which gives a ModuleScript"));
  project(R"({"$path": "b.model.json"})");
  file("b.model.json", R"({"ClassName": "Model", "Children": [{"ClassName": "Part"}, {}]})");
  EXPECT_THAT(error(), HasSubstr("b.model.json: Children[1].ClassName: expected the name"));
  project(R"({"$path": "."})");
  EXPECT_THAT(error(), HasSubstr("tree.$path: no instance can be made"));
}

TEST(RojoGlobs, StarsAndExceptions) {
  using rojo::matchesGlob;
  EXPECT_TRUE(matchesGlob("**/*.spec.lua", "a/b/c.spec.lua"));
  EXPECT_TRUE(matchesGlob("**/*.spec.lua", "c.spec.lua"));
  EXPECT_FALSE(matchesGlob("*.spec.lua", "a/c.spec.lua"));
  EXPECT_TRUE(matchesGlob("src/**", "src/a/b"));
  EXPECT_TRUE(matchesGlob("a?c", "abc"));
  EXPECT_FALSE(matchesGlob("a?c", "a/c"));
  EXPECT_TRUE(rojo::isIgnored({"**/*.lua", "!keep.lua"}, "a/b.lua"));
  EXPECT_FALSE(rojo::isIgnored({"**/*.lua", "!keep.lua"}, "keep.lua"));
}

TEST(RojoJson, CommentsAndLastCommasAreAllowed) {
  const auto tree =
      rojo::parseJson("{ // one\n \"a//b\": [1, 2, /* two, ] */ ], \"c\": \"\\\"//\", }");
  ASSERT_TRUE(tree) << tree.error().text();
  const rojo::Json json(*tree, tree->root());
  EXPECT_EQ(json["a//b"].numbers()->size(), 2u);
  EXPECT_EQ(json["c"].text(), "\"//");
  EXPECT_FALSE(rojo::parseJson("{,}"));
  EXPECT_FALSE(rojo::parseJson("{\"a"));
  EXPECT_FALSE(rojo::parseJson("/*"));
}

}  // namespace
}  // namespace obby::test
