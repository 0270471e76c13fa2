// A file that grows while others read it, a log: whatever ends the process, what append() was given
// is in the file, whole.
#pragma once

#include <atomic>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::io {

class Appender {
 public:
  // Adds to what is there. The error names the file and the reason. A named pipe waits for its
  // reader; `stop` as of Sink::open.
  static Result<Appender> open(const std::string& path, const std::atomic<bool>* stop = nullptr);

  Appender(Appender&& other) noexcept;
  Appender& operator=(Appender&& other) noexcept;
  ~Appender();

  // Of a disk; no device or pipe.
  bool isRegular() const;

  // After an error a regular file has nothing of the piece.
  Status append(std::string_view piece);

 private:
  Appender(std::string path, int fd, const std::atomic<bool>* stop)
      : path_(std::move(path)), fd_(fd), stop_(stop) {}

  std::string path_;
  int fd_;
  const std::atomic<bool>* stop_;
};

}  // namespace obby::io
