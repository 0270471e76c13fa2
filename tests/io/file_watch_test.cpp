#include "io/file_watch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scratch_folder.h"

namespace obby::io {
namespace {

void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

class FileWatchTest : public testing::Test {
 protected:
  void SetUp() override { put(path_, "one"); }
  // One folder per test, since tests of one binary run at the same time.
  const test::ScratchFolder folder_;
  const std::string path_ = folder_ / "watched";
  std::atomic<bool> never_{false};
};

TEST_F(FileWatchTest, NoticesWritingReplacingAndRemoval) {
  FileWatch watch({path_});
  EXPECT_FALSE(watch.changed());
  put(path_, "longer");
  EXPECT_TRUE(watch.changed());
  watch.settle(never_);
  EXPECT_FALSE(watch.changed());
  put(path_ + ".new", "another");
  std::filesystem::rename(path_ + ".new", path_);
  EXPECT_TRUE(watch.changed());
  watch.settle(never_);
  std::filesystem::remove(path_);
  EXPECT_TRUE(watch.changed());
}

TEST_F(FileWatchTest, NoticesTheSameBytesWrittenAgain) {
  FileWatch watch({path_});
  std::filesystem::last_write_time(
      path_, std::filesystem::last_write_time(path_) + std::chrono::seconds(1));
  EXPECT_TRUE(watch.changed());
}

TEST_F(FileWatchTest, AnyOfSeveralFilesCounts) {
  const std::string other = path_ + "-other";
  FileWatch watch({path_, other});
  EXPECT_FALSE(watch.changed());
  put(other, "now it is there");
  EXPECT_TRUE(watch.changed());
}

}  // namespace
}  // namespace obby::io
