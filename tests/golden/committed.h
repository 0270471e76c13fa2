// Text that a test makes, as a file of the repository has it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace obby::golden {

// With OBBY_WRITE_GOLDEN set writes the file instead, and skips the test.
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
