// Where output bytes go: a file, a pipe, a terminal, memory. Every failure down to close() is an
// Error, and a file appears under its name only when it is whole.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::io {

// Does close() wait until a regular file is on the disk under its name, so that it stays whole if
// the machine fails? That takes milliseconds.
enum class Durable { no, yes };

class Sink {
 public:
  // "-" is standard output. A regular file is written under a temporary name beside it
  // (output_file.h), which only a writer that is killed leaves there, until the next one of the
  // same file opens it; devices and named pipes are written directly; a named pipe waits for its
  // reader. Once `stop` is set, a pipe or terminal whose reader takes nothing for a second, or that
  // nobody opens for one, is given up with an error of isInterrupted(); without `stop` a signal
  // does that only to opening. A named pipe heeds whoever sets `stop`, other outputs a signal that
  // does.
  static Result<Sink> open(const std::string& path, Durable durable = Durable::no,
                           const std::atomic<bool>* stop = nullptr);
  // Appends to `bytes`, which must outlive the sink.
  static Sink toBytes(std::string* bytes);

  Sink(Sink&&) noexcept;
  Sink& operator=(Sink&&) noexcept;
  ~Sink();  // without close(): what was written to a file is removed

  // One whole piece (a line, a message, a page): goes out at once to pipes and terminals, in blocks
  // to files. After an error every later call gives that error again.
  Status write(std::string_view piece);
  Status flush();
  // Flushes, checks, and gives the file its name. Call it once.
  Status close();

  bool terminal() const;
  bool failed() const;              // an earlier call gave an error
  const std::string& name() const;  // "stdout" or the path, as errors say it

 private:
  struct Impl;
  explicit Sink(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// With a reader who takes nothing, once a tool has been told to stop.
inline constexpr int kPatienceMilliseconds = 1000;

// Whether the reader of `fd` takes more within so long; negative: waits for it. True as well if
// something else is the matter with `fd`: the next write says. A pipe then has room for PIPE_BUF
// bytes.
bool takesMore(int fd, int milliseconds);

// As open(2), to write. A named pipe waits for its reader: where there is a `stop`, which may be
// null, for so long once it is set (then -1, and errno is EINTR), and write(2) does not wait.
int openToWrite(const std::string& path, int flags, const std::atomic<bool>* stop);

// Writes all of it, and waits for the reader. False: it failed, and errno says why; EINTR: `stop`,
// which may be null, is set, and the reader takes nothing for so long.
bool sendAll(int fd, std::string_view bytes, const std::atomic<bool>* stop);

// True for the error of writing to a pipe that nobody reads any more: stop quietly.
bool isBrokenPipe(const Error& error);

}  // namespace obby::io
