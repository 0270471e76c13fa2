// Bytes of a file, a pipe or memory, read as they arrive. A buffer grows only by what has arrived,
// so that a false size costs nothing. It is for callers that must see how an input begins before
// they choose its reader. Others use StreamReader or readFile().
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::io {

// The name of standard input in errors.
inline constexpr const char* kStandardInput = "stdin";

// The message of an error for which isInterrupted() is true.
inline constexpr const char* kInterrupted = "interrupted";

// Returns an error from errno. It names the file and the failed action, such as "cannot read". For
// EINTR the message is kInterrupted.
Error fileError(const std::string& name, const char* doing);

class ByteSource {
 public:
  // "-" is standard input. Once `stop` is set, a waiting read ends and stopped() is true; a named
  // pipe need not have a writer yet. Without `stop`, a signal without SA_RESTART interrupts a
  // waiting call, with an error of isInterrupted().
  static Result<ByteSource> open(const std::string& path, const std::atomic<bool>* stop);
  static ByteSource overBytes(std::string bytes, std::string name);

  ByteSource(ByteSource&& other) noexcept;
  ByteSource& operator=(ByteSource&& other) noexcept;
  ~ByteSource();

  const std::string& name() const { return name_; }
  bool stopped() const { return stopped_; }

  // Returns the bytes not yet consumed. Valid until the next fill() or consume().
  std::string_view buffered() const { return std::string_view(buffer_).substr(begin_); }
  // Returns the offset in the input of the first buffered byte.
  uint64_t offset() const { return offset_; }
  void consume(size_t bytes);

  // Waits for more. Returns the number of bytes that arrived, 0 at the end (or when stopped).
  Result<size_t> fill();
  // Calls fill() until `bytes` are buffered. Returns false if the input ends first.
  Result<bool> need(size_t bytes);
  // Returns and consumes all bytes up to the end (or until stopped). More than `max` bytes are an
  // error; then nothing of a regular file is read.
  Result<std::string> rest(uint64_t max);

 private:
  ByteSource() = default;
  bool waitReadable() const;
  bool readAgain() const;
  uint64_t leftInFile() const;

  static constexpr size_t kChunk = size_t(64) << 10;

  std::string name_, buffer_;
  size_t begin_ = 0;
  size_t max_ = kChunk;  // max bytes that the next read asks for
  uint64_t offset_ = 0;
  int fd_ = -1;
  bool regular_ = true, ended_ = false, stopped_ = false;
  const std::atomic<bool>* stop_ = nullptr;
};

}  // namespace obby::io
