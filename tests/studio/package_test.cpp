// The plugin is packaged as one model file, which the importer reads back.
#include "package/package.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "bridge/limits.h"
#include "import/format/read_document.h"
#include "io/read_file.h"
#include "io/version.h"

namespace obby::studio {
namespace {

namespace fs = std::filesystem;

struct Source {
  std::string path, text;
};

// A temporary folder with sources of a plugin.
class Sources {
 public:
  explicit Sources(const std::vector<Source>& sources)
      : folder_(fs::path(testing::TempDir()) /
                ("obby-" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::remove_all(folder_);
    for (const Source& source : sources) {
      fs::create_directories((folder_ / source.path).parent_path());
      std::ofstream(folder_ / source.path, std::ios::binary) << source.text;
    }
  }
  Sources(const Sources&) = delete;
  Sources& operator=(const Sources&) = delete;
  ~Sources() { fs::remove_all(folder_); }
  std::string folder() const { return folder_.string(); }

 private:
  fs::path folder_;
};

constexpr const char* kCourse = OBBY_SOURCE_DIR "/levels/calibration/course.jsonl";

Document readBack(const std::string& folder) {
  auto bytes = packagePlugin(folder, kCourse);
  EXPECT_TRUE(bytes) << bytes.error().text();
  auto document = importer::readDocument(*bytes, "obby.rbxmx");
  EXPECT_TRUE(document) << document.error().text();
  return *std::move(document);
}

// Returns the instance at a path below the roots, or null.
const Instance* find(const Document& document, const fs::path& path) {
  const std::vector<InstanceId>* among = &document.roots;
  const Instance* found = nullptr;
  for (const auto& name : path) {
    found = nullptr;
    for (const auto id : *among) {
      if (document.instances[id].name == name) found = &document.instances[id];
    }
    if (!found) return nullptr;
    among = &found->children;
  }
  return found;
}

std::string sourceOf(const Instance* script) {
  return script ? propertyOr<std::string>(*script, "Source", "no source") : "absent";
}

TEST(Package, text_with_xml_markup_survives) {
  const std::string text = "return a < b and c > d, \"x & y\", t[t[1]]>2, [[<![CDATA[]]>]]\n\t]]>";
  const Sources sources(std::vector<Source>{{"init.server.luau", "--<&>\n"}, {"odd.luau", text}});
  const auto document = readBack(sources.folder());
  EXPECT_EQ(sourceOf(find(document, "obby")), "--<&>\n");
  EXPECT_EQ(sourceOf(find(document, "obby/odd")), text);
}

TEST(Package, folders_nest_and_other_files_are_ignored) {
  const Sources sources(std::vector<Source>{
      {"init.server.luau", "x"}, {"views/list.luau", "list"}, {"notes.md", "no script"}});
  const auto document = readBack(sources.folder());
  ASSERT_EQ(document.roots.size(), 1u);
  EXPECT_EQ(document.instances[document.roots[0]].className, "Script");
  ASSERT_NE(find(document, "obby/views"), nullptr);
  EXPECT_EQ(find(document, "obby/views")->className, "Folder");
  EXPECT_EQ(find(document, "obby/views/list")->className, "ModuleScript");
  EXPECT_EQ(document.instances.size(), 5u);  // these include the version and the course
}

TEST(Package, the_version_is_that_of_the_build) {
  const Sources sources(std::vector<Source>{{"init.server.luau", "x"}});
  const std::string text = sourceOf(find(readBack(sources.folder()), "obby/version"));
  EXPECT_NE(text.find("\"" + std::string(io::toolVersion()) + "\""), std::string::npos) << text;
  const std::string protocol = "protocol = " + std::to_string(bridge::kProtocol) + " ";
  EXPECT_NE(text.find(protocol), std::string::npos) << text;
}

TEST(Package, it_contains_the_calibration_course_of_levels) {
  const Sources sources(std::vector<Source>{{"init.server.luau", "x"}});
  const std::string text = sourceOf(find(readBack(sources.folder()), "obby/courseText"));
  const auto course = io::readFile(kCourse);
  ASSERT_TRUE(course);
  EXPECT_NE(text.find("[==[\n" + *course + "]==]"), std::string::npos);
  EXPECT_EQ(course->find("]==]"), std::string::npos);
  EXPECT_FALSE(packagePlugin(sources.folder(), sources.folder() + "/no course"));
}

TEST(Package, a_folder_without_a_script_is_an_error_that_names_it) {
  const Sources sources(std::vector<Source>{{"other.luau", "x"}});
  const auto plugin = packagePlugin(sources.folder(), kCourse);
  ASSERT_FALSE(plugin);
  EXPECT_NE(plugin.error().text().find("init.server.luau"), std::string::npos);
}

TEST(Package, it_contains_every_source_and_is_deterministic) {
  const std::string folder = OBBY_SOURCE_DIR "/studio/src";
  const auto document = readBack(folder);
  size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".luau" || entry.path().filename() == "init.server.luau")
      continue;
    ++files;
    const fs::path inside = fs::relative(entry.path(), folder).replace_extension();
    const auto text = io::readFile(entry.path().string());
    ASSERT_TRUE(text);
    EXPECT_EQ(sourceOf(find(document, "obby" / inside)), *text) << inside;
  }
  EXPECT_GT(files, 1u);
  EXPECT_EQ(*packagePlugin(folder, kCourse), *packagePlugin(folder, kCourse));
}

}  // namespace
}  // namespace obby::studio
