// A stream that stays open after its text but sends nothing more.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "train/timeout.h"

namespace obby::train {

// A pipe that contains a text and stays open.
class Standing {
 public:
  explicit Standing(const std::string& text) {
    EXPECT_EQ(pipe(ends_), 0);
    EXPECT_EQ(write(ends_[1], text.data(), text.size()), ssize_t(text.size()));
  }
  ~Standing() {
    for (const int end : ends_) close(end);
  }
  Standing(const Standing&) = delete;
  Standing& operator=(const Standing&) = delete;

  io::SourceOptions options(const Timeout& timeout) const {
    io::SourceOptions out;
    out.inputs = {fmt::format("/dev/fd/{}", ends_[0])};
    out.stop = &timeout.stop();
    return out;
  }

 private:
  int ends_[2] = {-1, -1};
};

}  // namespace obby::train
