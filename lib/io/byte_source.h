// Bytes of a file, a pipe or memory, read as they come: a buffer grows only by what has arrived, so
// that a claimed size costs nothing. For who must see how an input begins before it is known what
// reads it; otherwise StreamReader and readFile() are enough.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::io {

// The name of standard input in errors.
inline constexpr const char* kStandardInput = "stdin";

// The message of isInterrupted().
inline constexpr const char* kInterrupted = "interrupted";

// What errno says of a file: the error names it and what was being done, "cannot read"; of EINTR
// kInterrupted.
Error fileError(const std::string& name, const char* doing);

class ByteSource {
 public:
  // "-" is standard input. Once `stop` is set a waiting read ends and stopped() is true; a named
  // pipe need not have a writer yet. Without `stop` a signal whose handler lets calls come back
  // breaks off a call that waits, with an error of isInterrupted().
  static Result<ByteSource> open(const std::string& path, const std::atomic<bool>* stop);
  static ByteSource overBytes(std::string bytes, std::string name);

  ByteSource(ByteSource&& other) noexcept;
  ByteSource& operator=(ByteSource&& other) noexcept;
  ~ByteSource();

  const std::string& name() const { return name_; }
  bool stopped() const { return stopped_; }

  // Not yet consumed; valid until the next fill() or consume().
  std::string_view buffered() const { return std::string_view(buffer_).substr(begin_); }
  // Offset in the input of the first buffered byte.
  uint64_t offset() const { return offset_; }
  void consume(size_t bytes);

  // Waits for more; gives the number of bytes that came, 0 at the end (or when stopped).
  Result<size_t> fill();
  // fill() until `bytes` are buffered; false if the input ends before.
  Result<bool> need(size_t bytes);
  // All that is not yet consumed, up to the end (or until stopped); consumes it. Error: more than
  // `most` bytes, of a regular file before any of them is read.
  Result<std::string> rest(uint64_t most);

 private:
  ByteSource() = default;
  bool waitReadable() const;
  bool readAgain() const;
  uint64_t leftInFile() const;

  static constexpr size_t kChunk = size_t(64) << 10;

  std::string name_, buffer_;
  size_t begin_ = 0;
  size_t most_ = kChunk;  // bytes that the next read asks for, at most
  uint64_t offset_ = 0;
  int fd_ = -1;
  bool regular_ = true, ended_ = false, stopped_ = false;
  const std::atomic<bool>* stop_ = nullptr;
};

}  // namespace obby::io
