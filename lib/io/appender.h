// A file that grows while others read it, such as a log. However the process ends, every piece that
// was given to append() is in the file, whole.
#pragma once

#include <atomic>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::io {

class Appender {
 public:
  // Opens a file to append to. An error names the file and the reason. Opening a named pipe waits
  // for its reader. Sink::open explains `stop`.
  static Result<Appender> open(const std::string& path, const std::atomic<bool>* stop = nullptr);

  Appender(Appender&& other) noexcept;
  Appender& operator=(Appender&& other) noexcept;
  ~Appender();

  // Returns true for a file on a disk, false for a device or pipe.
  bool isRegular() const;

  // Appends a piece. After an error a regular file contains no part of it.
  Status append(std::string_view piece);

 private:
  Appender(std::string path, int fd, const std::atomic<bool>* stop)
      : path_(std::move(path)), fd_(fd), stop_(stop) {}

  std::string path_;
  int fd_;
  const std::atomic<bool>* stop_;
};

}  // namespace obby::io
