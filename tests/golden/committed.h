// Compares text from a test with a committed file.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace obby::golden {

// If OBBY_WRITE_GOLDEN is set, writes the file instead and skips the test.
inline void expectCommitted(const char* path, const std::string& now) {
  if (std::getenv("OBBY_WRITE_GOLDEN") != nullptr) {
    std::ofstream(path) << now;
    GTEST_SKIP() << "wrote " << path;
  }
  std::ifstream file(path);
  std::ostringstream committed;
  committed << file.rdbuf();
  EXPECT_EQ(committed.str(), now);
}

}  // namespace obby::golden
