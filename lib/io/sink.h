// The destination of output bytes: a file, a pipe, a terminal or memory. Every failure up to
// close() is an Error, and a file appears under its name only when it is complete.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::io {

// With `yes`, close() waits until a regular file is on the disk under its name. The file then
// survives a failure of the machine. The wait takes milliseconds.
enum class Durable { no, yes };

class Sink {
 public:
  // "-" is standard output. A regular file is written under a temporary name next to it
  // (output_file.h), which only a killed writer leaves behind. Devices and named pipes are written
  // directly; a named pipe waits for its reader. Once `stop` is set, an output is given up with an
  // error of isInterrupted() in two cases: a pipe or terminal whose reader takes nothing for a
  // second, and a pipe that no reader opens for a second. Without `stop` a signal does that only
  // while opening. Any thread may set `stop` for a named pipe; for other outputs a signal must
  // interrupt the write.
  static Result<Sink> open(const std::string& path, Durable durable = Durable::no,
                           const std::atomic<bool>* stop = nullptr);
  // Appends to `bytes`, which must outlive the sink.
  static Sink toBytes(std::string* bytes);

  Sink(Sink&&) noexcept;
  Sink& operator=(Sink&&) noexcept;
  ~Sink();  // removes the file if close() was not called

  // Writes one whole piece (a line, a message, a page), at once to pipes and terminals, in blocks
  // to files. After an error every later call returns that error again.
  Status write(std::string_view piece);
  Status flush();
  // Flushes, checks, and gives the file its name. Call it once.
  Status close();

  bool terminal() const;
  bool failed() const;              // an earlier call returned an error
  const std::string& name() const;  // "stdout" or the path, as in errors

 private:
  struct Impl;
  explicit Sink(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// Time for a reader that accepts nothing, once the tool was asked to stop.
inline constexpr int kPatienceMilliseconds = 1000;

// Returns true if the reader of `fd` takes more within this time; with a negative time, waits for
// the reader. Also returns true if `fd` has another problem, which the next write reports. If a
// pipe takes more, it has capacity for PIPE_BUF bytes.
bool takesMore(int fd, int milliseconds);

// Opens a file to write, like open(2). A named pipe waits for its reader. With `stop`, which may be
// null, write(2) to the pipe does not wait; once it is set and no reader comes within
// kPatienceMilliseconds, returns -1 with EINTR.
int openToWrite(const std::string& path, int flags, const std::atomic<bool>* stop);

// Writes all bytes, and waits for the reader. Returns false on failure, with the reason in errno.
// EINTR means that `stop`, which may be null, is set and the reader takes nothing within
// kPatienceMilliseconds.
bool sendAll(int fd, std::string_view bytes, const std::atomic<bool>* stop);

// Returns true for the error of a pipe whose reader has gone. The tool should stop quietly.
bool isBrokenPipe(const Error& error);

}  // namespace obby::io
