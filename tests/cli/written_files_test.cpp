// Tests which files a tool refuses to write.
#include "cli/written_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "cli/options.h"

namespace obby::cli {
namespace {

namespace fs = std::filesystem;

// Each test runs in an empty folder.
class WrittenFiles : public testing::Test {
 protected:
  WrittenFiles() : before_(fs::current_path()), folder_(fs::path(testing::TempDir()) / name()) {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
    fs::current_path(folder_);
  }
  ~WrittenFiles() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }

  static void make(const std::string& file) { std::ofstream(file) << "something"; }

  void give(const std::string& option, const std::string& file, bool renewed = false) {
    Arguments::Value& value = arguments_.values[option];
    value.row.name = option;
    value.row.type = ValueType::file;
    value.row.renewed = renewed;
    value.texts = {file};
    value.given = true;
  }

  // Returns the error, or an empty text.
  std::string refused(const std::vector<WrittenFile>& written) const {
    const Status status = refuseOverwriting(arguments_, written);
    return status ? std::string() : status.error().text();
  }

  Arguments arguments_;

 private:
  static std::string name() {
    return std::string("obby-") + testing::UnitTest::GetInstance()->current_test_info()->name();
  }

  fs::path before_, folder_;
};

TEST_F(WrittenFiles, AnInputIsRecognisedUnderAnyName) {
  make("in");
  fs::create_symlink("in", "link");
  fs::create_hard_link("in", "other");
  fs::create_directory("folder");
  arguments_.inputs = {"in"};
  EXPECT_EQ(refused({{"output", "in"}}), "--output: 'in' is also an input (name another file)");
  for (const char* same : {"./in", "folder/../in", "link", "other"})
    EXPECT_NE(refused({{"output", same}}), "") << same;
  for (const char* other : {"new", "", "folder", "folder/in", "/dev/null"})
    EXPECT_EQ(refused({{"output", other}}), "") << other;
  arguments_.inputs = {"folder", "link"};
  EXPECT_NE(refused({{"output", "in"}}), "");
  arguments_.inputs.clear();
  EXPECT_EQ(refused({{"output", "in"}}), "");
}

TEST_F(WrittenFiles, FilesNamedByOptionsAreKeptUnlessRenewed) {
  make("policy");
  give("policy", "policy");
  EXPECT_EQ(refused({{"output", "./policy"}}),
            "--output: './policy' is also used by --policy (name another file)");
  give("policy", "policy", true);
  EXPECT_EQ(refused({{"output", "policy"}}), "");
  // An option that names an output does not count as one that names an input.
  give("policy", "policy");
  EXPECT_EQ(refused({{"policy", "policy"}}), "");
  arguments_.values["policy"].given = false;
  EXPECT_EQ(refused({{"output", "policy"}}), "");
}

TEST_F(WrittenFiles, TwoOutputsMustDiffer) {
  EXPECT_EQ(refused({{"output", "new"}, {"log", "log"}, {"curve", "./new"}}),
            "--curve: './new' is also used by --output (name another file)");
  EXPECT_EQ(refused({{"output", "new"}, {"log", ""}, {"curve", ""}}), "");
  EXPECT_EQ(refused({{"output", "/dev/null"}, {"log", "/dev/null"}}), "");
  make("old");
  fs::create_symlink("old", "link");
  EXPECT_NE(refused({{"output", "old"}, {"log", "link"}}), "");
  EXPECT_EQ(refused({{"output", "old"}, {"log", "new"}}), "");
}

TEST_F(WrittenFiles, ALinkToAMissingFileCountsAsItsTarget) {
  fs::create_directory("runs");
  fs::create_symlink("runs/new", "link");
  fs::create_symlink("link", "link to it");
  EXPECT_EQ(refused({{"output", "runs/new"}, {"checkpoint", "link"}}),
            "--checkpoint: 'link' is also used by --output (name another file)");
  EXPECT_NE(refused({{"output", "link to it"}, {"checkpoint", "./runs/new"}}), "");
  EXPECT_NE(refused({{"output", "link"}, {"checkpoint", "link to it"}}), "");
  EXPECT_EQ(refused({{"output", "link"}, {"checkpoint", "runs/other"}}), "");
  fs::create_symlink("round", "round");  // a link to itself
  EXPECT_EQ(refused({{"output", "link"}, {"checkpoint", "round"}}), "");
}

}  // namespace
}  // namespace obby::cli
