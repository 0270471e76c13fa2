// obby-import as a filter: inputs of every kind as streams of records, and the same level from each
// of the file formats.
#include "import/filter.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "io/stream.h"
#include "support/place_writer.h"

namespace obby::test {
namespace {

namespace fs = std::filesystem;

class Filter : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("obby_filter_") + test->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& bytes) {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  importer::InputOpener opener(importer::ImportOptions options = {}) {
    return {std::move(options), [this](const std::string& text) { said_.push_back(text); },
            [this](const std::string& text) { explained_ += text; }};
  }

  // Returns every record of an input as JSON lines.
  std::string lines(importer::InputOpener& inputs, const std::string& path) {
    auto reader = inputs.open(path);
    EXPECT_TRUE(reader) << reader.error().text();
    if (!reader) return "";
    std::string bytes;
    auto writer = io::StreamWriter::toBytes(io::Format::jsonl, &bytes);
    for (;;) {
      auto record = reader->next();
      EXPECT_TRUE(record) << record.error().text();
      if (!record || !*record) return bytes;
      EXPECT_TRUE(writer.pass(**record));
    }
  }

  fs::path folder_;
  std::vector<std::string> said_;
  std::string explained_;
};

PlaceWriter smallPlace() {
  PlaceWriter place;
  const auto workspace = place.add("Workspace", "Workspace");
  const auto start = place.add("SpawnLocation", "SpawnLocation", workspace);
  const auto lava = place.add("Part", "Lava", workspace);
  const auto goal = place.add("Part", "WinPad", workspace);
  const auto script = place.add("Script", "KillScript", lava);
  float z = 0;
  for (const auto id : {start, lava, goal}) {
    place.set(id, "size", vec3(8, 1, 8)).set(id, "CFrame", cframe(0.1f, 0, z));
    place.set(id, "Anchored", flag(true));
    z -= 12.3f;
  }
  place.set(script, "Source",
            source("script.Parent.Touched:Connect(function(hit)\n  local h = "
                   "hit.Parent:FindFirstChild(\"Humanoid\")\n  if h then h.Health = 0 end\nend)"));
  place.tag(goal, "Goal");
  return place;
}

TEST_F(Filter, EveryFormatGivesTheSameRecords) {
  const PlaceWriter place = smallPlace();
  const std::string files[] = {
      file("a.bin", place.binary(Packing::Stored)), file("b.bin", place.binary(Packing::Lz4)),
      file("c.bin", place.binary(Packing::Zstd)), file("d.bin", place.xml())};
  std::vector<std::string> outputs;
  for (const auto& path : files) {
    auto inputs = opener({"same", true, false});
    std::string text = lines(inputs, path);
    for (const std::string& varies : {path, std::string("rbxlx"), std::string("rbxl")})
      if (const size_t at = text.find(varies); at != std::string::npos)
        text.replace(at, varies.size(), "*");
    outputs.push_back(text);
  }
  for (const auto& output : outputs) EXPECT_EQ(output, outputs[0]);
  EXPECT_NE(outputs[0].find("\"reason\":\"script KillScript line 3"), std::string::npos);
  EXPECT_NE(outputs[0].find("\"id\":\"stage1\""), std::string::npos);
}

TEST_F(Filter, RecordsPassThroughUnchanged) {
  const std::string text =
      "{\"type\":\"level\",\"name\":\"mine\",\"parts\":[{\"name\":\"Floor\"}]}\n"
      "{\"type\":\"query\",\"id\":\"q\",\"level\":\"mine\"}\n";
  auto inputs = opener();
  EXPECT_EQ(lines(inputs, file("hand.jsonl", text)), text);
}

// A stream may be larger than memory, and its writer may wait for the filter's output.
TEST_F(Filter, RecordsAreReadAsTheyCome) {
  const std::string path = (folder_ / "pipe").string();
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int writer =
      ::open(path.c_str(), O_RDWR);  // opening for reading and writing does not wait for a reader
  ASSERT_GE(writer, 0);
  const std::string first = "\n {\"type\":\"query\",\"id\":\"q\"}\n";
  ASSERT_EQ(::write(writer, first.data(), first.size()), ssize_t(first.size()));
  auto inputs = opener();
  auto reader = inputs.open(path);
  ASSERT_TRUE(reader) << reader.error().text();
  const auto record = reader->next();
  ASSERT_TRUE(record && *record);
  EXPECT_STREQ((*record)->reader().getQuery().getId().cStr(), "q");
  ::close(writer);
}

TEST_F(Filter, LevelsOfSeveralInputsHaveDifferentNames) {
  const std::string path = file("tower.rbxlx", smallPlace().xml());
  auto inputs = opener();
  EXPECT_NE(lines(inputs, path).find("\"name\":\"tower\""), std::string::npos);
  const std::string second = lines(inputs, path);
  EXPECT_NE(second.find("\"name\":\"tower-2\""), std::string::npos);
  EXPECT_NE(second.find("\"level\":\"tower-2\""), std::string::npos);
}

TEST_F(Filter, ErrorsNameTheInput) {
  auto inputs = opener();
  const auto missing = inputs.open((folder_ / "none.rbxl").string());
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().text().find("none.rbxl: cannot open"), std::string::npos);
  const std::string whole = smallPlace().binary(Packing::Stored);
  const auto cut = inputs.open(file("cut.rbxl", whole.substr(0, whole.size() / 2)));
  ASSERT_FALSE(cut);
  EXPECT_NE(cut.error().text().find("cut.rbxl"), std::string::npos);
}

TEST_F(Filter, ExplainsPlacesAndReportsOtherInputs) {
  auto inputs = opener({"", true, true});
  (void)lines(inputs, file("tower.rbxlx", smallPlace().xml()));
  EXPECT_NE(explained_.find("script KillScript line 3"), std::string::npos);
  (void)lines(inputs, file("hand.jsonl", "{\"type\":\"query\",\"id\":\"q\"}\n"));
  EXPECT_NE(explained_.find("nothing to explain"), std::string::npos);
}

TEST_F(Filter, ExplainedNamesHaveNoControlCharacters) {
  PlaceWriter place;
  const auto workspace = place.add("Workspace", "Workspace");
  const auto goal = place.add("Part", "Win\xc2\x9b\xe2\x80\xaePad", workspace);
  place.set(goal, "size", vec3(8, 1, 8)).set(goal, "CFrame", cframe(0, 0, 0));
  place.set(goal, "Anchored", flag(true));
  place.tag(goal, "Goal");
  auto inputs = opener({"", true, true});
  (void)lines(inputs, file("tower.rbxl", place.binary(Packing::Stored)));
  EXPECT_NE(explained_.find("Win  Pad"), std::string::npos) << explained_;
}

}  // namespace
}  // namespace obby::test
