#include "io/file_watch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace obby::io {
namespace {

void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

class FileWatchTest : public testing::Test {
 protected:
  const std::string path_ = testing::TempDir() + "obby-file-watch";
  void SetUp() override { put(path_, "one"); }
  void TearDown() override { std::filesystem::remove(path_); }
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

TEST_F(FileWatchTest, NoticesTheSameBytesWrittenAnew) {
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
  std::filesystem::remove(other);
}

}  // namespace
}  // namespace obby::io
